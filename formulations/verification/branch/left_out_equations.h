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

/// The equations of a model that modelling left out, since they follow from others where a linkage
/// closes, or are between constants. One holds at an instant if its residual is explained by the
/// digits of the file: if it may vanish for some mechanism that rounds to the same file
/// (with_file_variation()). A certificate for these mechanisms bounds how far their positions are
/// from those of the file. So what closes before rounding is never flagged, and what is flagged is
/// proven not to close.
///
///   LeftOutEquations left_out(model);
///   if (const auto misfit = left_out.check(refined)) …   // no exact motion exists
///
/// Between instants, one is enclosed along the tube of each step (PathProof): steps are so short
/// that no misfit is overlooked which modelling would refuse in a drawing (`max_misfit`).
///
/// Costs a certificate of positions where the instant's own radii do not explain all residuals;
/// else an evaluation of these equations. One thread at a time may use it.
class LeftOutEquations {
 public:
  /// Allocates everything. The model's estimate is its drawing. The model must outlive this.
  explicit LeftOutEquations(const Model& model);
  explicit LeftOutEquations(const Model&& model) = delete;

  bool any() const { return !equations_.empty(); }

  /// Returns the misfit of the equation that is proven not to hold by most, over the lengths of its
  /// points. An instant that is not proven proves nothing. drivers: those that were handed in,
  /// which count as exact; null: the model's motions. Allocates nothing.
  std::optional<Misfit> check(const RefinedInstant& refined, const LiveRow* drivers = nullptr);

  /// A misfit, and the time where it was found [s].
  struct Between {
    Misfit misfit;
    double time;
  };

  /// Returns whether a misfit is one that modelling refuses in a drawing: more than digits of a
  /// file leave.
  bool is_contradiction(const Misfit& misfit) const;

  /// Looks for misfits along the last step of a path, which is proven, and notes the largest.
  /// Returns false where the step is too long to tell.
  bool look_along(const PathProof& step);
  /// Returns the largest misfit that look_along() has noted since this was called last. Drivers
  /// count as exact there.
  std::optional<Between> take_between() { return std::exchange(between_, {}); }
  const std::optional<Between>& between() const { return between_; }
  /// Notes a misfit that was found along a step.
  void note(const std::optional<Between>& found) {
    if (found && (!between_ || found->misfit.amount > between_->misfit.amount)) between_ = found;
  }

  /// Returns for each coordinate how far it may be from that of any mechanism that rounds to the
  /// same file; infinite where that is not known. Two choices of equations mean the same motion
  /// where their instants are within these radii. Only where any() is true. Valid until the next
  /// call of this, check() or look_along().
  std::span<const double> find_radius(const Instant& instant, const LiveRow* drivers = nullptr);

 private:
  Interval residual(const Equation& equation, std::span<const double> q,
                    std::span<const double> radius) const;
  /// Returns the misfit of a residual in `state_`, over the lengths of equation i or in rad.
  double relative(std::size_t i, double residual) const;
  void go_to(const PathProof& step, double s);
  double worst_place(std::size_t i, const PathProof& step);
  bool is_told_at(std::size_t i, const PathProof& step, double s);

  const Model& m_;
  Model varied_;
  std::vector<Equation> equations_;
  std::vector<double> length_;  // of each equation
  std::optional<Certifier> certifier_;
  std::optional<Refinement> refinement_;  // of instants between rows
  std::vector<double> state_, drivers_;
  std::optional<Between> between_;
};

}  // namespace desmo
