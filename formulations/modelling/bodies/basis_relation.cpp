#include "formulations/modelling/bodies/basis_relation.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

namespace desmo {

namespace {

using nominal::Vec;
using Direction = Mechanism::Direction;

/// target = [origin +] Σ cᵢ directionᵢ
struct Relation {
  std::string name;
  const Basis& basis;
  EntityId target;
  bool is_point;     // then from the origin
  Vec offset;        // of the target from the origin, nominally
  double magnitude;  // what the offset was subtracted from
};

void relate_in_plane(EquationWriter& w, const Relation& r) {
  if (r.basis.directions.empty())  // a second name for the same place
    return w.constrain<Rigid<2, 0>>(Origin::body, r.name, {r.target, w.point(r.basis.origin)}, {});
  const Direction& d = r.basis.directions.front();
  const Vec x = nominal::direction(w.mechanism, d);
  const double x2 = nominal::dot(x, x), least = r.magnitude / std::sqrt(x2);
  const std::array c{snap(nominal::dot(x, r.offset) / x2, least),
                     snap((x[0] * r.offset[1] - x[1] * r.offset[0]) / x2, least)};
  if (r.is_point && d.is_line())
    w.constrain<PlanarRelation<true, true>>(Origin::body, r.name,
                                            {r.target, w.point(d.from), w.point(d.to)}, c);
  else if (r.is_point)
    w.constrain<PlanarRelation<true, false>>(
        Origin::body, r.name, {r.target, w.point(r.basis.origin), w.vector(d.vector)}, c);
  else if (d.is_line())
    w.constrain<PlanarRelation<false, true>>(Origin::body, r.name,
                                             {r.target, w.point(d.from), w.point(d.to)}, c);
  else
    w.constrain<PlanarRelation<false, false>>(Origin::body, r.name, {r.target, w.vector(d.vector)},
                                              c);
}

/// Calls f<T>() with T = terms, up to Most.
template <int Most, class F>
void with_terms(std::size_t terms, F&& f) {
  [&]<int... T>(std::integer_sequence<int, T...>) {
    ((terms == T ? f.template operator()<T>() : void()), ...);
  }
  (std::make_integer_sequence<int, Most + 1>{});
}

/// The cᵢ, without what rounding leaves.
std::vector<double> coefficients_in_space(const Mechanism& d, const Relation& r) {
  const int n = static_cast<int>(r.basis.directions.size());
  if (n == 0) return {};
  Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions(3, n);
  for (int k = 0; k < n; ++k) {
    const Vec x = nominal::direction(d, r.basis.directions[k]);
    for (int i = 0; i < 3; ++i) directions(i, k) = x[i];
  }
  const Eigen::VectorXd solution = directions.colPivHouseholderQr().solve(
      Eigen::Vector3d(r.offset[0], r.offset[1], r.offset[2]));
  std::vector<double> c;
  for (int k = 0; k < n; ++k)
    c.push_back(snap(solution[k], r.magnitude / directions.col(k).norm()));
  return c;
}

/// A line ends at the sum of itself and the origin, so that its term is its end and takes as
/// much away from the origin.
void relate_in_space(EquationWriter& w, const Relation& r) {
  const std::vector<double> c = coefficients_in_space(w.mechanism, r);
  double of_origin = r.is_point ? 1 : 0;
  bool has_lines = false;
  std::vector<EntityId> terms;
  std::vector<double> coefficients;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c[k] == 0) continue;
    const Direction& d = r.basis.directions[k];
    if (d.is_line()) {
      has_lines = true;
      of_origin -= c[k];
    }
    terms.push_back(d.is_line() ? w.point(d.to) : w.vector(d.vector));
    coefficients.push_back(c[k]);
  }
  if (r.is_point && !has_lines)
    return with_terms<3>(terms.size(), [&]<int T>() {
      std::array<EntityId, T + 2> operands{r.target, w.point(r.basis.origin)};
      std::array<double, T> values{};
      std::copy_n(terms.begin(), T, operands.begin() + 2);
      std::copy_n(coefficients.begin(), T, values.begin());
      w.constrain<Rigid<3, T>>(Origin::body, r.name, operands, values);
    });
  of_origin = snap(of_origin, 1);
  if (of_origin != 0) {
    terms.insert(terms.begin(), w.point(r.basis.origin));
    coefficients.insert(coefficients.begin(), of_origin);
  }
  with_terms<4>(terms.size(), [&]<int T>() {
    if constexpr (T > 0) {
      std::array<EntityId, T + 1> operands{r.target};
      std::array<double, T> values{};
      std::copy_n(terms.begin(), T, operands.begin() + 1);
      std::copy_n(coefficients.begin(), T, values.begin());
      w.constrain<Combination<3, T>>(Origin::body, r.name, operands, values);
    }
  });
}

void relate(EquationWriter& w, const Relation& r) {
  w.mechanism.dimension == 2 ? relate_in_plane(w, r) : relate_in_space(w, r);
}

}  // namespace

void relate_point(EquationWriter& w, const std::string& prefix, const RigidBody& body, int p) {
  relate(w, {prefix + w.mechanism.points[p].name + " rigid", body.basis, w.point(p), true,
             nominal::direction(w.mechanism, body, {-1, body.basis.origin, p}), w.reach});
}

void relate_vector(EquationWriter& w, const std::string& prefix, const RigidBody& body, int v) {
  const Mechanism::Vector& vector = w.mechanism.vectors[v];
  relate(w, {prefix + vector.name + " rigid", body.basis, w.vector(v), false, vector.direction, 1});
}

}  // namespace desmo
