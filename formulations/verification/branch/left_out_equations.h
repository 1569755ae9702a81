#pragma once

#include <optional>
#include <span>
#include <vector>

#include "cases/numbers/interval.h"
#include "formulations/base/live_row.h"
#include "formulations/model/partition.h"
#include "formulations/verification/branch/misfit.h"
#include "formulations/verification/certificate/refinement.h"

namespace desmo {

/// The equations of a model that modelling left out, since they follow from others where a linkage
/// closes. One holds at an instant if its residual is explained by the digits of the file: if it
/// may vanish for some mechanism that rounds to the same file (with_file_variation()). A
/// certificate for these mechanisms bounds how far their positions are from those of the file. So
/// what closes before rounding is never flagged, and what is flagged is proven not to close.
///
///   LeftOutEquations left_out(model);
///   if (const auto misfit = left_out.check(refined)) …   // no exact motion exists
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

  /// Returns for each coordinate how far it may be from that of any mechanism that rounds to the
  /// same file; infinite where that is not known. Two choices of equations mean the same motion
  /// where their instants are within these radii. Only where any() is true. Valid until the next
  /// call of this or check().
  std::span<const double> radius(const Instant& instant, const LiveRow* drivers = nullptr);

 private:
  Interval residual(const Equation& equation, std::span<const double> q,
                    std::span<const double> radius) const;
  bool holds(const Equation& equation, std::span<const double> q,
             std::span<const double> radius) const;

  const Model& m_;
  Model varied_;
  std::vector<Equation> equations_;
  std::vector<double> length_;  // of each equation
  std::optional<Certifier> certifier_;
  std::vector<double> state_;
};

}  // namespace desmo
