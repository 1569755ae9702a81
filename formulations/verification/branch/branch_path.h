#pragma once

#include <functional>
#include <optional>
#include <span>
#include <utility>

#include "formulations/model/model.h"
#include "formulations/verification/branch/followed_step.h"
#include "formulations/verification/certificate/path_proof.h"
#include "formulations/verification/certificate/refinement.h"

namespace desmo {

/// Returns a refined instant that is proven as a certified one in the same memory. levels: up to
/// which each coordinate is solved (CertifiedInstant).
inline CertifiedInstant certified(const RefinedInstant& r, std::span<const Level> levels = {}) {
  return {r.instant.time, {r.instant.q, r.instant.qd, r.instant.qdd}, r.radius.position, levels};
}

/// The one follower of paths: goes from a proven instant along the motion, in steps that are all
/// proven (PathProof), and says whether an instant lies on it. Sub-steps need no formulation: the
/// corrections of certificates (Refinement) lead from Taylor's polynomial to the solution.
///
///   BranchPath path(model);
///   path.start_at(first);                                   // a refined instant
///   if (path.follow(next).end == PathEnd::other) …          // the step has jumped
class BranchPath {
 public:
  static constexpr int max_tests = 10000;

  /// budget: path proofs of one step, after which it counts as stuck. The model must outlive this.
  explicit BranchPath(const Model& model, int budget = max_tests);
  explicit BranchPath(const Model&& model, int budget = max_tests) = delete;

  /// Asks about each step that is proven. Where the answer is false, shorter ones are taken.
  void ask_about_steps(std::function<bool(const PathProof&)> is_accepted) {
    is_accepted_ = std::move(is_accepted);
  }

  /// Begins at a copy of an instant. Trusts one that has all rates, else proves it and finds them.
  /// Returns whether that succeeds.
  bool start_at(const CertifiedInstant& instant);

  /// Goes to the time of an instant, later or earlier. The next step begins there: at the instant
  /// if that continues the motion, else at the end that was found; where the motion is stuck, at
  /// the last proven instant. At the present time it says whether the instant is the present one.
  FollowedStep follow(const CertifiedInstant& to);
  /// Goes to another time, where present() then is (`same`), or as far as the motion leads
  /// (`stuck`).
  FollowedStep go_to(double time);

  /// Returns whether positions lie in the tube of the last step, which was proven at the first try,
  /// or no farther from it than so many tolerances (coordinates).
  bool contains(double time, std::span<const double> q, std::span<const double> tolerances,
                double count) const;

  /// Returns the instant where the next step begins, up to its accelerations.
  const CertifiedInstant& present() const { return present_; }

 private:
  FollowedStep go(double time, const CertifiedInstant* to);
  PathCertificate prove(const CertifiedInstant& to);
  double up_to_knot(double time) const;
  void keep(const RefinedInstant& refined);
  const RefinedInstant& predict(double time);

  const Model& m_;
  const int budget_;
  Refinement refinement_;
  PathProof path_;  // shares its blocks
  std::function<bool(const PathProof&)> is_accepted_;
  InstantCopy memory_;
  CertifiedInstant present_;                 // what is in memory
  GroupId worst_conditioned_ = no_position;  // there, if it is known
  InstantCopy predicted_;
};

}  // namespace desmo
