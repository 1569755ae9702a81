#include "formulations/verification/range/followed_curve.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/model/misfit.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

namespace {

/// Returns whether a driver is the distance of two points. Its equation is quadratic, so that it
/// holds for negative values, too, which mean nothing.
bool is_positive(const Model& m, EntityId driver) {
  const auto is_square = [&](const Constraint& c) {
    return (c.kind == kind_index<Distance<2>>() || c.kind == kind_index<Distance<3>>()) &&
           c.operands.back() == driver;
  };
  return std::ranges::any_of(m.constraints, is_square);
}

}  // namespace

FollowedCurve::FollowedCurve(const Model& m, int driver, const RangeLimits& limits)
    : model(m),
      curve(m, driver, limits),
      driver_magnitude(nominal_magnitudes(m)[m.entities[m.drivers[driver].coordinate].first]),
      is_driver_positive(is_positive(m, m.drivers[driver].coordinate)) {}

FollowedCurve::FollowedCurve(std::unique_ptr<const Model> m, int driver, const RangeLimits& limits)
    : FollowedCurve(*m, driver, limits) {
  own = std::move(m);
}

bool FollowedCurve::is_violated(const SolutionCurve::Point& point) const {
  for (int c = 0; c < static_cast<int>(model.constraints.size()); ++c) {
    const Constraint& constraint = model.constraints[c];
    if (constraint.left_out == 0) continue;
    const std::vector<double> phi = residual_of(model, constraint, point.state);
    for (int row = 0; row < rows(constraint); ++row) {
      if (!(constraint.left_out >> row & 1)) continue;
      const Misfit misfit = misfit_of(model, c, row, phi[row], point.state);
      if (misfit.over(lengths.of(constraint)) > max_misfit) return true;
    }
  }
  return false;
}

}  // namespace desmo
