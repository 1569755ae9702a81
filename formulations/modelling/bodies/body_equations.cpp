#include "formulations/modelling/bodies/body_equations.h"

#include "formulations/modelling/bodies/basis_relation.h"

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;
using Direction = Mechanism::Direction;

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
