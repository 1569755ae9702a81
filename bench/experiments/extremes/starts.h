#pragma once

#include <vector>

#include "cases/extremes/extremes.h"
#include "formulations/model/model.h"

namespace desmo::extremes {

/// Estimates of a mechanism's positions that are off by up to `off` of natural magnitudes, the
/// drivers' excepted: evenly distributed, the same in every run.
std::vector<std::vector<double>> make_starts(const Model& model, const ExtremeCase::Starts& starts);

}  // namespace desmo::extremes
