#include "formulations/model/misfit.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "formulations/constraints/constraints.h"
#include "formulations/model/incidence.h"
#include "formulations/model/scales.h"

namespace desmo {

std::vector<double> residual_of(const Model& m, const Constraint& c,
                                std::span<const double> state) {
  std::vector<double> phi(rows(c));
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    const auto x = operands_of<Kind>(m, c, state.data());
    Kind::residual(x.data(), dimensions_at<Kind>(c, x.data()).data(), phi.data());
  });
  return phi;
}

Misfit misfit_of(const Model& m, int constraint, int row, double residual,
                 std::span<const double> state) {
  const Constraint& c = m.constraints[constraint];
  Misfit result{constraint, 0, false};
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    const auto x = operands_of<Kind>(m, c, state.data());
    // norm of the derivatives by each operand
    std::array<double, Kind::operand_sizes.size()> slope{};
    Kind::jacobian(x.data(), dimensions_at<Kind>(c, x.data()).data(),
                   [&](int r, int operand, int, double value) {
                     if (r == row) slope[operand] = std::hypot(slope[operand], value);
                   });
    double steepest[2] = {0, 0};  // largest slope: [0] by other operands, [1] by lengths
    for (std::size_t k = 0; k < x.size(); ++k) {
      double& most = steepest[is_length(m.entities[c.operands[k]].kind)];
      most = std::max(most, slope[k]);
    }
    result.is_length = steepest[1] > 0;
    result.amount = std::abs(residual) / steepest[result.is_length];
  });
  return result;
}

}  // namespace desmo
