#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <utility>
#include <vector>

#include "bench/experiments/promise/drawn_scene.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo::promise {

/// An instant that a run delivered.
struct Delivered {
  int index;
  bool degraded;
  std::vector<double> q, qd, qdd;
};

/// A monitored run, as its user sees it.
struct SolvedScene {
  MonitoredSummary summary;
  std::vector<Delivered> instants;
  double tolerance;
  bool is_single = false;  ///< in single precision
};

/// Verdict on a run.
enum class PromiseVerdict {
  right,           ///< without a flag
  flagged,         ///< with one for which there is a cause
  false_flag,      ///< with one for which there is none: the motion is well-conditioned, and all
                   ///< numbers are right
  false_failure,   ///< failed where the motion is well-conditioned
  wrong,           ///< a wrong number without a flag
  not_applicable,  ///< the formulation does not offer these settings
};

/// The letter of each verdict in a record, in the order of the enumerators.
inline constexpr std::array<std::pair<PromiseVerdict, char>, 6> verdict_letters{{
    {PromiseVerdict::right, '.'},
    {PromiseVerdict::flagged, 'f'},
    {PromiseVerdict::false_flag, 'F'},
    {PromiseVerdict::false_failure, 'N'},
    {PromiseVerdict::wrong, 'W'},
    {PromiseVerdict::not_applicable, '-'},
}};
static_assert(std::ranges::all_of(verdict_letters, [i = 0](const auto& row) mutable {
  return static_cast<int>(row.first) == i++;
}));

/// A verdict, and the number that it is about.
struct RunVerdict {
  PromiseVerdict verdict = PromiseVerdict::right;
  /// Names what is broken: "promise" (100 to 100³ times the tolerance), "bound" (that was stated),
  /// "no answer" (a singular position, or out of reach). On the first instants of a run that
  /// failed ", then failed" follows. For flags: which.
  std::string what = {};
  Level level = Level::position;
  double error = 0, allowed = 0;  ///< of the worst number
  double time = 0;                ///< [s]
  double condition = 0;           ///< true one of this instant
};

/// Returns the errors of an instant in units of a scale.
PerLevel<double> errors_of(const Model& model, const ReferenceInstant& truth,
                           const Delivered& instant, const Scales& scales);

/// Judges a run. A number is wrong without a flag if
/// - its instant is neither degraded nor after a singularity crossing that was reported, and its
///   error exceeds the limits of *converged* or the bound stated for the run, or
/// - its instant is degraded and its error exceeds the bound stated, or
/// - there is no answer, and no flag at this instant (but see DrawnScene::overconstrained).
RunVerdict verdict_on_run(const DrawnScene& scene, const SolvedScene& solved);

/// Solves a scene as `desmo solve` does and judges it.
RunVerdict verdict_on_id(const DrawnScene& scene, const std::string& id);

}  // namespace desmo::promise
