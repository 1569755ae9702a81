#pragma once

#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "cases/numbers/interval.h"
#include "formulations/base/live_row.h"
#include "formulations/model/misfit.h"
#include "formulations/model/partition.h"
#include "formulations/verification/certificate/path_proof.h"
#include "formulations/verification/certificate/refinement.h"

namespace desmo {

/// The equations of a model that modelling left out. They are between constants, or follow from
/// others if the linkage closes. An equation may hold at an instant if its residual may vanish for
/// some mechanism that rounds to the same file (with_file_variation()). A certificate bounds how
/// far the positions of these mechanisms are from those of the file. So a linkage that closes
/// before its numbers are rounded is never flagged, and a flagged one is proven not to close.
///
///   LeftOutEquations left_out(model);
///   if (const auto misfit = left_out.check(refined)) …   // no exact motion exists
///
/// Between instants, each equation is enclosed along the tube of each step (PathProof). A step is
/// too long if the enclosure allows a misfit above `max_misfit`, which modelling refuses in a
/// drawing, and none is found. The digits of the file, or rounding, may leave open even at a point
/// whether there is such a misfit. Then shorter steps are not asked for.
///
/// check() costs an evaluation of these equations and, where the instant's own radii do not explain
/// all residuals, a certificate of positions. One thread at a time may use this object.
class LeftOutEquations {
 public:
  /// Allocates everything. The model's estimate is its drawing. The model must outlive this object.
  explicit LeftOutEquations(const Model& model);
  explicit LeftOutEquations(const Model&& model) = delete;

  bool any() const { return !equations_.empty(); }

  /// Returns the largest misfit, over the length of its equation, among the equations that are
  /// proven not to hold. Returns nothing if there is none or the instant is not proven. Allocates
  /// nothing.
  /// - drivers: values that were handed in, which count as exact; null: the model's motions
  std::optional<Misfit> check(const RefinedInstant& refined, const LiveRow* drivers = nullptr);

  /// A misfit, and the time where it was found [s].
  struct Between {
    Misfit misfit;
    double time;
  };

  /// Looks for misfits along a step that was just proven, and notes the largest. Returns false if
  /// the step is too long to tell.
  bool look_along(const PathProof& step);
  /// Returns and forgets the noted misfit. Driver values count as exact where it was found.
  std::optional<Between> take_between() { return std::exchange(between_, {}); }
  const std::optional<Between>& between() const { return between_; }
  /// Notes a misfit that was found along a step, if it exceeds the noted one (Misfit::relative).
  void note(const std::optional<Between>& found) {
    if (found && (!between_ || found->misfit.relative > between_->misfit.relative))
      between_ = found;
  }

 private:
  /// Returns the misfit that a residual of equation i means. Slopes are taken at `state_`.
  Misfit misfit(std::size_t i, double residual) const;
  void go_to(const PathProof& step, double s);
  double worst_place(std::size_t i, const PathProof& step);
  bool is_told_at(std::size_t i, const PathProof& step, double s);

  const Model& m_;
  Model varied_;
  std::vector<Equation> equations_;
  std::vector<double> length_;         // characteristic length of each equation
  std::vector<std::size_t> changing_;  // positions of the equations that are not between constants
  std::optional<Certifier> certifier_;
  std::optional<Refinement> refinement_;  // of instants between rows
  std::vector<double> state_, drivers_;
  std::optional<Between> between_;
};

}  // namespace desmo
