#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/model/model.h"
#include "formulations/verification/assessment/scaled_system.h"

namespace desmo {

/// Continuation of a model's nominal position: all equations at once, in steps whose rates lead
/// from one end to the other, with determinants of irreducible blocks that keep their signs. So it
/// ends on the branch that the initial estimate declares. It allocates: keep it out of timed code.
class NominalContinuation {
 public:
  /// The model and its system, whose factors are overwritten, must outlive this object.
  NominalContinuation(const Model& model, ScaledSystem& system);

  /// Solves the nominal position: that of the estimate, drivers included. Returns whether there is
  /// one, regular and so near the estimate that this declares it.
  bool begin();
  /// Begins at solved positions q (coordinates) in place of the nominal ones. The way there is then
  /// followed closely: predictions are off by a tenth of the distance to a singular position at
  /// most, so that no step passes one. Returns whether the positions are regular.
  bool begin_at(std::span<const double> q);
  /// Moves the drivers from the nominal position straight to where they are at an instant; without
  /// the whole turns of angles where these are many, or block the way. Returns whether steps lead
  /// there.
  bool go_to(const Instant& instant);
  /// Returns whether these positions (coordinates) are the ones reached, give or take the whole
  /// turns that were left out.
  bool leads_to(std::span<const double> q);
  /// Returns the position reached (coordinates), with drivers as at the instant.
  std::span<const double> q() const { return reached_.q; }

 private:
  bool go(std::span<const double> changes, std::span<const double> guess);
  bool arrives(double step);
  bool solve(std::span<double> q, bool is_factorised = false);
  double correct(std::span<double> q);
  bool solve_rates(std::span<double> qd);
  double farthest(std::span<const double> q) const;
  bool leads_on(double step) const;
  bool keeps_branch();
  double condition();
  double own_condition();
  bool is_close(std::span<const double> predicted);

  const Model& model_;
  ScaledSystem& system_;
  std::vector<double> magnitude_;
  State nominal_, reached_, next_;  // q and its derivative along the way
  bool is_at_nominal_ = false;      // the factors are
  bool turns_ = false;              // whole turns were left out
  bool is_followed_closely_ = false;
  double own_condition_ = 0;        // of the position reached, then
  std::vector<signed char> signs_;  // of the nominal position
  std::vector<double> determinants_, state_;
  Eigen::ArrayXd off_;          // (rows) of the equations
  double last_correction_ = 0;  // of the position solved last, with factors hardly off it
};

}  // namespace desmo
