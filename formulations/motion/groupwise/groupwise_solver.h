#pragma once

#include <cstddef>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"
#include "formulations/motion/groupwise/reference_solver.h"

namespace desmo {

/// A solver of a model, group by group with dense matrices and pivoting, in the scalar S, by the
/// paper's equations. Newton's method (eq. 2) finds positions. Velocities (eq. 3) and accelerations
/// (eq. 4) use the partial derivatives and quadratic terms of the constraint kinds. S is double or,
/// with the library desmo_reference, Quadruple.
template <class S>
class GroupwiseSolver : public ReferenceSolver<S> {
 public:
  /// Starts at the model's initial estimate. The model must outlive the solver.
  explicit GroupwiseSolver(const Model& model);

  /// Makes later calls solve Φ = share · Φ₀, where Φ₀ is Φ at the positions of the first
  /// set_homotopy().
  void set_homotopy(double share);
  /// Makes one correction by Newton's method, group after group. Returns its largest component
  /// relative to the nominal magnitude; NaN or infinity where a group is singular.
  double correct_positions();

  /// Solves the positions at time t [s] as accurately as S allows, from the present ones. Throws
  /// std::runtime_error, naming the group and the instant, when Newton's method does not converge.
  void solve_positions(double t);

  /// Solves velocities and accelerations at the positions solved last. They are not finite where a
  /// group is singular.
  void solve_rates();

 private:
  using ReferenceSolver<S>::m_;
  using ReferenceSolver<S>::state_;

  void solve_positions(std::size_t part, double t);
  double correct(std::size_t part);

  std::vector<PartDefinition> parts_;
  std::vector<std::vector<S>> initial_;  // Φ₀ of each part; empty: none
  double share_ = 0;                     // factor of Φ₀
};

}  // namespace desmo
