#pragma once

#include <array>

#include "cases/mechanism/motion.h"
#include "formulations/parts/profile.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// Names of the phases in the record. The rest is loops, copies, drivers and delivery.
inline constexpr std::array<const char*, phase_count + 1> phase_names{
    "residual", "jacobian", "factorisation", "solve", "right_hand_sides", "rest"};

/// Wall-clock time of a step by phase [s], without the cost of reading the clock. It is the mean
/// over one pass over the motion: of several passes, the one with the median total.
using PhaseTimes = std::array<double, phase_names.size()>;

/// Measures the phases over the instants of a grid, with a formulation made for that. Throws
/// std::runtime_error where the motion cannot be solved.
PhaseTimes measure_phases(const Variant& variant, const Settings& settings, const Model& model,
                          const TimeGrid& grid);

}  // namespace desmo::paper
