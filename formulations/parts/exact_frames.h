#pragma once

#include <Eigen/Core>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/equations/equations.h"
#include "formulations/model/model.h"
#include "formulations/model/partition.h"
#include "formulations/parts/jacobian_factors.h"

namespace desmo {

/// Newton iterations in which a linear system corrects all unknowns, derived ones included.
struct LinearisedFrames {
  static void residual(const Equations& equations, const double* q, Eigen::VectorXd& phi) {
    equations.residual(q, phi.data());
  }
  static void solve(JacobianFactors& factors, Eigen::VectorXd& b) { factors.solve(b); }

  /// Returns solve_position(frames), where `frames` evaluates derived unknowns in the iterations of
  /// the part's next position.
  template <class Call>
  [[gnu::always_inline]] PartResult choose(const Call& solve_position) {
    return solve_position(*this);
  }
  void forget() {}        // as Part::forget()
  void end_assembly() {}  // as Part::end_assembly()
};

/// Newton iterations on x, the unknowns of a part that are not derived. Derivations are explicit in
/// the unknowns y that they derive. They are evaluated in their order: each reads x and the y
/// derived before. Newton's method then solves
///
///   Φ_c(x, y(x)) = 0,     with the Jacobian A_r = C_x − C_y D_y⁻¹ D_x (see Condensed).
///
/// Derivations hold except for rounding, so that neither of the two passes of Condensed::solve()
/// around A_r⁻¹ is needed.
///
/// An assembly iterates with linearised frames. From an estimate far off, y(x) leads farther away
/// the longer the chain of bodies is: with 140 dyads in one part Newton's method did not converge.
class ExactFrames {
 public:
  using MakeEquations = std::function<std::unique_ptr<const Equations>(const PartDefinition&)>;

  /// - derived: the derivations of the part (see derivations())
  /// - make_equations: makes the evaluation of some equations of the part, as many as unknowns
  ExactFrames(const Model& model, const PartDefinition& part, std::span<const Derivation> derived,
              const MakeEquations& make_equations);

  /// Overwrites the derived unknowns in q by their values at the others, and phi (n) by Φ there.
  /// Rows of derivations become 0, or NaN where a derived unknown is not finite.
  void residual(const Equations&, double* q, Eigen::VectorXd& phi);

  static void solve(JacobianFactors& factors, Eigen::VectorXd& b) { factors.solve_closures(b); }

  /// Like LinearisedFrames::choose(): linearised frames in an assembly, these ones in a step.
  template <class Call>
  PartResult choose(const Call& solve_position) {
    LinearisedFrames linearised;
    return is_assembling_ ? solve_position(linearised) : solve_position(*this);
  }
  void forget() { is_assembling_ = true; }
  void end_assembly() { is_assembling_ = false; }

 private:
  struct DerivedUnknown {
    int place, row;  // position in the state, row among the equations of its level
    double inverse;  // 1 / (derivative of its equation by it): ±1
  };
  /// Derivations that read nothing of the part but x and what earlier levels derive.
  struct Level {
    std::unique_ptr<const Equations> equations;
    std::vector<DerivedUnknown> derived;
  };

  static Level make_level(const Model& model, std::unique_ptr<const Equations> equations);

  std::vector<Level> levels_;
  std::unique_ptr<const Equations> closures_;
  std::vector<int> closure_row_;  // row of each closure among the part's equations
  std::vector<double> residual_;  // workspace: Φ of a level or of the closures
  bool is_assembling_ = true;
};

}  // namespace desmo
