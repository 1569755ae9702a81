#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <utility>

#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;
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

/// Writes the linear equation by which a body's point follows from the basis, which it is not in.
void relate_point(EquationWriter& w, const std::string& prefix, const RigidBody& body, int p) {
  relate(w, {prefix + w.mechanism.points[p].name + " rigid", body.basis, w.point(p), true,
             nominal::direction(w.mechanism, body, {-1, body.basis.origin, p}), w.reach});
}

/// Writes the same equation for a vector.
void relate_vector(EquationWriter& w, const std::string& prefix, const RigidBody& body, int v) {
  const Mechanism::Vector& vector = w.mechanism.vectors[v];
  relate(w, {prefix + vector.name + " rigid", body.basis, w.vector(v), false, vector.direction, 1});
}

template <int D>
void hold_ground_vectors(EquationWriter& w) {
  for (const int v : w.rigid.list.front().vectors) {
    if (w.coordinates().model.entities[w.vector(v)].fixed) continue;
    const Mechanism::Vector& vector = w.mechanism.vectors[v];
    const EntityId held = w.add_fixed_vector("ground: " + vector.name, vector.direction);
    w.constrain<Rigid<D, 0>>(Origin::ground, vector.name + " on the ground", {w.vector(v), held},
                             {});
  }
}

/// Of two different directions of a basis, in space; vectors come before lines.
void keep_product_of_two(EquationWriter& w, const std::string& name, const Direction& a,
                         const Direction& b, const Vec& u, const Vec& v) {
  const double product =
      snap(nominal::dot(u, v), (a.is_line() ? w.reach : 1) * (b.is_line() ? w.reach : 1));
  const std::string product_name = name + w.text(a) + " with " + w.text(b);
  if (a.is_line()) {  // both from the same point: the distance of their ends says the same
    const Vec ends = v - u;
    w.constrain<Length<3>>(Origin::body, name + w.text({-1, a.to, b.to}) + " length",
                           {w.point(a.to), w.point(b.to)}, {nominal::dot(ends, ends)});
  } else if (b.is_line()) {
    w.constrain<Projection<3>>(Origin::body, product_name,
                               {w.vector(a.vector), w.point(b.from), w.point(b.to)}, {product});
  } else {
    w.constrain<Dot<3>>(Origin::body, product_name, {w.vector(a.vector), w.vector(b.vector)},
                        {product});
  }
}

template <int D>
void keep_product(EquationWriter& w, const std::string& name, const RigidBody& body,
                  const Direction& a, const Direction& b) {
  const Vec u = nominal::direction(w.mechanism, body, a),
            v = nominal::direction(w.mechanism, body, b);
  if (!w.note_product(a, b, nominal::dot(u, v))) return;
  if (!a.is_line() && a.vector == b.vector)
    return w.constrain<Unit<D>>(Origin::body, name + w.text(a) + " unit", {w.vector(a.vector)}, {});
  if (a.is_line() && a.to == b.to) {
    const auto length = nominal::stated_length(body, a);
    return w.constrain<Length<D>>(Origin::body, name + w.text(a) + " length",
                                  {w.point(a.from), w.point(a.to)},
                                  {length ? *length * *length : nominal::dot(u, u)});
  }
  if constexpr (D == 3) keep_product_of_two(w, name, a, b, u, v);
}

template <int D>
void keep_along(EquationWriter& w, const std::string& name, const RigidBody& body, int v) {
  const Mechanism::Vector& vector = w.mechanism.vectors[v];
  const auto& [from, to] = *vector.along;
  const double length = nominal::length(w.mechanism, body, {-1, from, to});
  w.constrain<Rigid<D, 1>>(Origin::body, name + vector.name + " along " + w.text({-1, from, to}),
                           {w.point(to), w.point(from), w.vector(v)}, {length});
}

template <int D>
void write_body(EquationWriter& w, const RigidBody& body) {
  const std::string name = w.mechanism.bodies[body.bodies.front()].name + ": ";
  const std::vector<Direction>& directions = body.basis.directions;
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = i; j < directions.size(); ++j)
      keep_product<D>(w, name, body, directions[i], directions[j]);
  for (const int p : body.points)
    if (!body.basis.has_point(p)) relate_point(w, name, body, p);
  for (const int v : body.vectors)
    if (follows_from_points(w.mechanism, body, v))
      keep_along<D>(w, name, body, v);
    else if (!body.basis.has_vector(v))
      relate_vector(w, name, body, v);
}

}  // namespace

template <int D>
void write_body_equations(EquationWriter& w) {
  hold_ground_vectors<D>(w);
  for (std::size_t r = 1; r < w.rigid.list.size(); ++r) write_body<D>(w, w.rigid.list[r]);
}

template void write_body_equations<2>(EquationWriter&);
template void write_body_equations<3>(EquationWriter&);

}  // namespace desmo
