#pragma once

#include <functional>
#include <span>
#include <utility>

#include "formulations/model/model.h"
#include "formulations/verification/branch/followed_step.h"
#include "formulations/verification/branch/test_budget.h"
#include "formulations/verification/certificate/path_proof.h"
#include "formulations/verification/certificate/refinement.h"

namespace desmo {

/// Returns a certified instant that views a refined one, which must be proven.
/// - levels: see CertifiedInstant
inline CertifiedInstant certified(const RefinedInstant& r, std::span<const Level> levels = {}) {
  return {r.instant.time, {r.instant.q, r.instant.qd, r.instant.qdd}, r.radius.position, levels};
}

/// Follower of a motion from a proven instant, in steps that are all proven (PathProof). It says
/// whether an instant lies on the motion. Sub-steps need no formulation: the corrections of
/// certificates (Refinement) lead from Taylor's polynomial to the solution.
///
///   BranchPath path(model);
///   path.start_at(first);                                   // certified instants
///   if (path.follow(next).end == PathEnd::other) …          // the step has jumped
class BranchPath {
 public:
  static constexpr int max_tests = 10000;  ///< default budget

  /// budget: maximum number of path proofs in one call of follow() or go_to(), after which it is
  /// stuck. The model must outlive this object.
  explicit BranchPath(const Model& model, int budget = max_tests);
  explicit BranchPath(const Model&& model, int budget = max_tests) = delete;

  /// Sets a function that is asked about each proven step. If it returns false, the step counts as
  /// unproven, and shorter ones are tried.
  void ask_about_steps(std::function<bool(const PathProof&)> is_accepted) {
    is_accepted_ = std::move(is_accepted);
  }

  /// Begins at a copy of an instant. An instant with all rates counts as proven, and needs radii.
  /// If rates are missing, finds them and proves the instant. Returns whether that succeeds.
  bool start_at(const CertifiedInstant& instant);

  /// Goes to the time of an instant, later or earlier. Then present() is
  /// - `same`: the instant, with all rates
  /// - `other`: the solution at that time on the motion followed
  /// - `stuck`: the last proven instant
  /// If present() has that time already, it stays: `same` if the certified boxes of both instants
  /// meet, else `other`.
  FollowedStep follow(const CertifiedInstant& to);
  /// Goes to another time (`same`), or as far as the motion leads (`stuck`).
  FollowedStep go_to(double time);
  /// Like go_to(time), but with half of a budget that other paths share. Takes at least one test
  /// from it.
  FollowedStep go_to(double time, TestBudget& budget);

  /// Returns whether positions q at a time [s] of the last step lie in its tube, up to rounding.
  /// The tube is widened by count × tolerance of each coordinate. The step must have been proven at
  /// the first try (FollowedStep::sub_steps == 1): after sub-steps, the tube is that of the last
  /// one tested.
  /// - q, tolerances: (coordinates)
  bool contains(double time, std::span<const double> q, std::span<const double> tolerances,
                double count) const;

  /// Returns the instant where the next step begins, with all rates.
  const CertifiedInstant& present() const { return present_; }

 private:
  FollowedStep go(double time, const CertifiedInstant* to, int budget);
  bool proves(const CertifiedInstant& to, FollowedStep& report);
  double up_to_knot(double time) const;
  void keep(const RefinedInstant& refined);
  const RefinedInstant& predict(double time);

  const Model& m_;
  const int budget_;
  Refinement refinement_;
  PathProof path_;  // shares the blocks of refinement_
  std::function<bool(const PathProof&)> is_accepted_;
  InstantCopy memory_;
  CertifiedInstant present_;                 // view of memory_
  GroupId worst_conditioned_ = no_position;  // group of the worst condition number at present_
  InstantCopy predicted_;
};

}  // namespace desmo
