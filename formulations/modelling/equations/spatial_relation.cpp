#include <Eigen/QR>

#include "cases/numbers/space.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using ExactVec = BodyDrawing<Derived>::Vec;

/// Returns the coefficients by Cramer's rule, for which Derived numbers have enough digits.
std::vector<Derived> by_determinants(const std::vector<ExactVec>& u, const ExactVec& offset) {
  if (u.size() == 1) return {dot(u[0], offset) / dot(u[0], u[0])};
  if (u.size() == 2) {
    // The normal equations: offset·uᵢ = Σ cₖ uₖ·uᵢ
    const Derived a = dot(u[0], u[0]), b = dot(u[0], u[1]), d = dot(u[1], u[1]);
    const Derived x = dot(offset, u[0]), y = dot(offset, u[1]), determinant = a * d - b * b;
    return {(x * d - y * b) / determinant, (y * a - x * b) / determinant};
  }
  std::vector<Derived> c;
  for (int k = 0; k < 3; ++k) {
    const ExactVec normal = cross(u[(k + 1) % 3], u[(k + 2) % 3]);
    c.push_back(dot(offset, normal) / dot(u[k], normal));
  }
  return c;
}

}  // namespace

std::vector<Derived> coefficients_in_space(const Mechanism& mechanism, const RigidBody& body,
                                           const Mechanism::Direction& offset, double magnitude) {
  const auto& basis = body.basis.directions;
  const int n = static_cast<int>(basis.size());
  if (n == 0) return {};
  const BodyDrawing<double> rounded{mechanism};
  const BodyDrawing<Derived> exact{mechanism};
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions(3, n);
  std::vector<ExactVec> exact_directions;
  for (int k = 0; k < n; ++k) {
    directions.col(k) = Eigen::Vector3d(rounded.direction(body, basis[k]).data());
    exact_directions.push_back(exact.direction(body, basis[k]));
  }
  const Eigen::VectorXd solution = directions.colPivHouseholderQr().solve(
      Eigen::Vector3d(rounded.direction(body, offset).data()));
  std::vector<Derived> c = by_determinants(exact_directions, exact.direction(body, offset));
  for (int k = 0; k < n; ++k)
    c[k] = is_rounding(solution[k], magnitude / directions.col(k).norm()) ? Derived(0)
                                                                          : c[k].about(solution[k]);
  return c;
}

}  // namespace desmo
