#pragma once

#include <array>

#include "bench/experiments/paper/options.h"
#include "cases/mechanism/motion.h"
#include "formulations/parts/profile.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// Wall-clock seconds of a step by phase, the clock's own cost taken off: of the pass with the
/// median total among several.
struct PhaseTimes {
  std::array<double, phase_count> seconds{};
  double rest = 0;  ///< loops, copies, drivers, delivery

  double total() const;
};

/// Names of the phases in the record.
inline constexpr std::array<const char*, phase_count> phase_names{
    "residual", "jacobian", "factorisation", "solve", "right_hand_sides"};

/// Measures where the time goes, over the instants of a grid, with a formulation made for that.
PhaseTimes measure_phases(const Variant& variant, const Settings& settings, const Model& model,
                          const TimeGrid& grid);

}  // namespace desmo::paper
