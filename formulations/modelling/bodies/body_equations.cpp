#include <array>
#include <string>
#include <vector>

#include "cases/numbers/space.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using Direction = Mechanism::Direction;

/// The equation target = [origin +] Σ cᵢ directionᵢ of a body's point or vector in its basis.
struct Relation {
  std::string name;
  const RigidBody& body;
  EntityId target;
  Direction offset;  // line from the origin to the target point, or the target vector
  double magnitude;  // largest coordinate [unit of length] of the points of that line; vector: 1

  bool is_point() const { return offset.is_line(); }
};

void relate_in_plane(EquationWriter& w, const Relation& r) {
  const Basis& basis = r.body.basis;
  if (basis.directions.empty())  // the target is at the origin
    return w.derive<Rigid<2, 0>>(EquationSource::body, r.name, {r.target, w.point(basis.origin)},
                                 {});
  const Direction& d = basis.directions.front();
  const double length = nominal::norm(BodyDrawing<double>{w.mechanism}.direction(r.body, d));
  // Seen from the origin, all four kinds measure the same.
  const auto c = measured<PlanarRelation<PlanarTarget::vector, DirectionOf::vector>>(
      w.mechanism, r.magnitude / length, [&](const auto& drawing) {
        return std::array{drawing.direction(r.body, r.offset), drawing.direction(r.body, d)};
      });
  if (r.is_point() && d.is_line())
    w.derive<PlanarRelation<PlanarTarget::point, DirectionOf::line>>(
        EquationSource::body, r.name, {r.target, w.point(d.from), w.point(d.to)}, c);
  else if (r.is_point())
    w.derive<PlanarRelation<PlanarTarget::point, DirectionOf::vector>>(
        EquationSource::body, r.name, {r.target, w.point(basis.origin), w.vector(d.vector)}, c);
  else if (d.is_line())
    w.derive<PlanarRelation<PlanarTarget::vector, DirectionOf::line>>(
        EquationSource::body, r.name, {r.target, w.point(d.from), w.point(d.to)}, c);
  else
    w.derive<PlanarRelation<PlanarTarget::vector, DirectionOf::vector>>(
        EquationSource::body, r.name, {r.target, w.vector(d.vector)}, c);
}

/// Writes a relation in space. The term of a line is its end point, which is the origin plus the
/// line. So the coefficient of each line is subtracted from that of the origin.
void relate_in_space(EquationWriter& w, const Relation& r) {
  static constexpr std::array rigid{kind_index<Rigid<3, 0>>(), kind_index<Rigid<3, 1>>(),
                                    kind_index<Rigid<3, 2>>(), kind_index<Rigid<3, 3>>()};
  static constexpr std::array combination{
      kind_index<Combination<3, 1>>(), kind_index<Combination<3, 2>>(),
      kind_index<Combination<3, 3>>(), kind_index<Combination<3, 4>>()};
  const Basis& basis = r.body.basis;
  const std::vector<Derived> c = coefficients_in_space(w.mechanism, r.body, r.offset, r.magnitude);
  Derived of_origin = r.is_point() ? 1 : 0;
  bool has_lines = false;
  std::vector<EntityId> terms;
  std::vector<Derived> coefficients;
  for (std::size_t k = 0; k < c.size(); ++k) {
    if (c[k].value == 0) continue;
    const Direction& d = basis.directions[k];
    if (d.is_line()) {
      has_lines = true;
      of_origin = of_origin - c[k];
    }
    terms.push_back(d.is_line() ? w.point(d.to) : w.vector(d.vector));
    coefficients.push_back(c[k]);
  }
  if (r.is_point() && !has_lines) {
    terms.insert(terms.begin(), {r.target, w.point(basis.origin)});
    return w.constrain(EquationSource::body, r.name, rigid[coefficients.size()], terms,
                       coefficients, 0);
  }
  if (!is_rounding(of_origin.value, 1)) {
    terms.insert(terms.begin(), w.point(basis.origin));
    coefficients.insert(coefficients.begin(), of_origin);
  }
  if (terms.empty()) return;
  terms.insert(terms.begin(), r.target);
  w.constrain(EquationSource::body, r.name, combination[coefficients.size() - 1], terms,
              coefficients, 0);
}

/// Writes the linear equation by which a body's point or vector follows from the basis, which it is
/// not in. offset: the line from the origin to the point, or the vector
void relate(EquationWriter& w, const std::string& prefix, const RigidBody& body,
            const Direction& offset) {
  const bool is_point = offset.is_line();
  const std::string& name =
      is_point ? w.mechanism.points[offset.to].name : w.mechanism.vectors[offset.vector].name;
  const Relation r{prefix + name + " rigid", body,
                   is_point ? w.point(offset.to) : w.vector(offset.vector), offset,
                   is_point ? reach_of(w.mechanism, body, w.reach) : 1};
  w.mechanism.dimension == 2 ? relate_in_plane(w, r) : relate_in_space(w, r);
}

template <int D>
void hold_ground_vectors(EquationWriter& w) {
  for (const int v : w.rigid.list.front().vectors) {
    if (w.coordinates().model.entities[w.vector(v)].fixed) continue;
    const Mechanism::Vector& vector = w.mechanism.vectors[v];
    const EntityId held = w.add_fixed_vector("ground: " + vector.name, vector);
    w.constrain<Rigid<D, 0>>(EquationSource::ground, vector.name + " on the ground",
                             {w.vector(v), held}, {});
  }
}

/// Keeps the product of two different directions of a basis in space. Vectors come before lines.
void keep_product_of_two(EquationWriter& w, const std::string& name, const RigidBody& body,
                         const Direction& a, const Direction& b) {
  const std::string product_name = name + w.text(a) + " with " + w.text(b);
  const auto both = [&](const auto& drawing) {
    return std::array{drawing.direction(body, a), drawing.direction(body, b)};
  };
  if (a.is_line()) {  // both from the same point: the distance of their ends says the same
    w.constrain<Length<3>>(EquationSource::body, name + w.text({-1, a.to, b.to}) + " length",
                           {w.point(a.to), w.point(b.to)},
                           measured<Length<3>>(w.mechanism, 0, both));
  } else if (b.is_line()) {
    w.constrain<Projection<3>>(
        EquationSource::body, product_name, {w.vector(a.vector), w.point(b.from), w.point(b.to)},
        measured<Projection<3>>(w.mechanism, reach_of(w.mechanism, body, w.reach),
                                [&](const auto& drawing) {
                                  return std::array{drawing.direction(body, a), drawing.origin(),
                                                    drawing.direction(body, b)};
                                }));
  } else {
    w.constrain<Dot<3>>(EquationSource::body, product_name,
                        {w.vector(a.vector), w.vector(b.vector)},
                        measured<Dot<3>>(w.mechanism, 1, both));
  }
}

template <int D>
void keep_product(EquationWriter& w, const std::string& name, const RigidBody& body,
                  const Direction& a, const Direction& b) {
  const BodyDrawing<double> drawing{w.mechanism};
  const nominal::Vec x = drawing.direction(body, a), y = drawing.direction(body, b);
  const auto rounded = [&](const Direction& d) {
    return d.is_line() ? reach_of(w.mechanism, body, w.reach) : 1;
  };
  const double magnitude = rounded(a) * nominal::norm(y) + rounded(b) * nominal::norm(x);
  if (!w.note_product(a, b, dot(x, y), magnitude)) return;
  if (!a.is_line() && a.vector == b.vector)
    return w.constrain<Unit<D>>(EquationSource::body, name + w.text(a) + " unit",
                                {w.vector(a.vector)}, {});
  if (a.is_line() && a.to == b.to)
    return w.constrain<Length<D>>(EquationSource::body, name + w.text(a) + " length",
                                  {w.point(a.from), w.point(a.to)},
                                  measured<Length<D>>(w.mechanism, 0, [&](const auto& drawn) {
                                    return std::array{drawn.origin(), drawn.direction(body, a)};
                                  }));
  if constexpr (D == 3) keep_product_of_two(w, name, body, a, b);
}

template <int D>
void keep_along(EquationWriter& w, const std::string& name, const RigidBody& body, int v) {
  const Mechanism::Vector& vector = w.mechanism.vectors[v];
  const auto& [from, to] = *vector.along;
  const Direction line{-1, from, to};
  w.constrain<Rigid<D, 1>>(EquationSource::body, name + vector.name + " along " + w.text(line),
                           {w.point(to), w.point(from), w.vector(v)},
                           measured<Rigid<D, 1>>(w.mechanism, 0, [&](const auto& drawing) {
                             return std::array{drawing.direction(body, line), drawing.origin()};
                           }));
}

/// Writes the products of a body's basis, or the derivation of its frame. Writes the relations of
/// its other points and vectors. For a point that an earlier body derives, the relation closes the
/// joint there. A vector that one derives has none (see plan_cut_joints()).
template <int D>
void write_body(EquationWriter& w, int r, bool has_frame) {
  const RigidBody& body = w.rigid.list[r];
  w.begin(r);
  const std::string name = w.mechanism.bodies[body.bodies.front()].name + ": ";
  const std::vector<Direction>& directions = body.basis.directions;
  if (has_frame) write_frame(w, r);
  for (std::size_t i = 0; !has_frame && i < directions.size(); ++i)
    for (std::size_t j = i; j < directions.size(); ++j)
      keep_product<D>(w, name, body, directions[i], directions[j]);
  for (const int p : body.points)
    if (!body.basis.has_point(p)) relate(w, name, body, {-1, body.basis.origin, p});
  for (const int v : body.vectors)
    if (!has_frame && follows_from_points(w.mechanism, body, v))
      keep_along<D>(w, name, body, v);
    else if (!body.basis.has_vector(v) && (!has_frame || w.framed->deriving_vector[v] == r))
      relate(w, name, body, {v});
}

}  // namespace

template <int D>
void write_body_equations(EquationWriter& w) {
  hold_ground_vectors<D>(w);
  if (w.framed) {
    for (const int r : w.framed->tree.order) write_body<D>(w, r, w.framed->tree.has_frame[r]);
    return;
  }
  for (int r = 1; r < static_cast<int>(w.rigid.list.size()); ++r) write_body<D>(w, r, false);
}

template void write_body_equations<2>(EquationWriter&);
template void write_body_equations<3>(EquationWriter&);

}  // namespace desmo
