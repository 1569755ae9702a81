#pragma once

#include <optional>
#include <vector>

#include "formulations/base/settings.h"
#include "formulations/model/misfit.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns the assembly error of the first group that cannot be assembled: the misfit of its worst
/// satisfied equation, at the position that satisfies all best. Nothing when all groups can be,
/// even in a singular position. Levenberg and Marquardt's method minimises the group's equations,
/// each over its magnitude, in least squares. It allocates: keep it out of timed code.
/// - state: the last instant solved, with the drivers of the instant that failed; the start
/// - settings: its tolerance decides whether a group is assembled
std::optional<Misfit> find_assembly_error(const Model& model, std::vector<double> state,
                                          const Settings& settings);

}  // namespace desmo
