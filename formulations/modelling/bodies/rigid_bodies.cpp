#include "formulations/modelling/bodies/rigid_bodies.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "cases/mechanism/checks.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/formatted.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/bodies/drawing.h"

namespace desmo {

namespace nominal {

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double norm(const Vec& a) { return std::sqrt(dot(a, a)); }

double extent(const Mechanism& mechanism) {
  double largest = 0;
  for (const Mechanism::Point& p : mechanism.points)
    largest = std::max(largest, norm(p.position - mechanism.points.front().position));
  return largest > 0 ? largest : 1;
}

}  // namespace nominal

namespace {

using nominal::Vec;

/// Adds to an orthonormal set the component of v that is normal to it, scaled to length 1. Adds
/// nothing and returns false when the sine of the angle between v and their span is < min_sine.
bool extend(std::vector<Vec>& orthonormal, Vec v, double min_sine) {
  const double length = nominal::norm(v);
  if (length == 0) return false;
  for (int pass = 0; pass < 2; ++pass)
    for (const Vec& u : orthonormal) {
      const double along = dot(u, v);
      for (int i = 0; i < 3; ++i) v[i] -= along * u[i];
    }
  const double remaining = nominal::norm(v);
  if (remaining < min_sine * length) return false;
  for (double& x : v) x /= remaining;
  orthonormal.push_back(v);
  return true;
}

Basis choose_basis(const Mechanism& mechanism, const RigidBody& body) {
  const std::size_t enough = mechanism.dimension == 2 ? 1 : 3;
  const BodyDrawing<double> drawing{mechanism};
  Basis basis;
  std::vector<Vec> orthonormal;
  if (!body.points.empty()) basis.origin = body.points.front();
  const auto add = [&](double min_sine, std::size_t max_directions) {
    for (const int v : body.vectors)
      if (!follows_from_points(mechanism, body, v) && orthonormal.size() < max_directions &&
          !basis.has_vector(v) && extend(orthonormal, drawing.direction(body, {v}), min_sine))
        basis.directions.push_back({v});
    for (const int p : body.points) {
      const Mechanism::Direction line{-1, basis.origin, p};
      if (orthonormal.size() < max_directions && !basis.has_point(p) &&
          extend(orthonormal, drawing.direction(body, line), min_sine))
        basis.directions.push_back(line);
    }
  };
  // Directions nearly in the span of others make bad coordinates. Where there is no choice, a
  // second one is taken all the same; a normal may replace a third one (with_plane_normals()).
  add(0.1, enough);
  add(1e-6, std::min<std::size_t>(enough, 2));
  std::ranges::stable_partition(basis.directions, [](const auto& x) { return !x.is_line(); });
  return basis;
}

int count_freedoms(int dimension, const Basis& basis) {
  const int translations = basis.origin >= 0 ? dimension : 0;
  const int directions = static_cast<int>(basis.directions.size());
  if (dimension == 2) return translations + directions;
  return translations + (directions < 2 ? 2 * directions : 3);
}

/// Limits of a length, in any unit: its square is a normal number in double precision.
constexpr double min_length = 1e-152, max_length = 1e152;

void require_representable(double length, const std::string& body) {
  if (length == 0 || !std::isfinite(length) || (length >= min_length && length <= max_length))
    return;
  throw std::invalid_argument(
      "body '" + body +
      formatted(
          "': the square of a length of %.0e on it is beyond double precision; choose another "
          "unit of length",
          length));
}

/// Adds the points or vectors that a body carries to the list of its rigid body, each once. Adds
/// the rigid body to the carriers of each.
void list_carried(const std::vector<int>& carried, int rigid_body, std::vector<int>& list,
                  std::vector<std::vector<int>>& carriers) {
  for (const int x : carried) {
    if (!carriers[x].empty() && carriers[x].back() == rigid_body) continue;
    carriers[x].push_back(rigid_body);
    list.push_back(x);
  }
}

/// Gives the two points of a body their stated length. Where a fixed joint adds other points or the
/// ground, the drawing must have that length, to 1e-9 of it. Throws std::invalid_argument if not.
void state_length(const Mechanism& mechanism, const Mechanism::Body& part, RigidBody& body) {
  const Drawing<Derived> drawing{mechanism};
  const int p = part.points[0], q = part.points[1];
  auto line = drawing.direction({-1, p, q});
  const Derived drawn = sqrt(dot(line, line));
  if (body.bodies.front() == 0 || body.points.size() > 2) {
    if (std::abs(drawn.value - part.length->value) <= 1e-9 * part.length->value) return;
    throw std::invalid_argument(
        "body '" + mechanism.bodies[body.bodies.front()].name + "': the length of '" +
        mechanism.points[p].name + "'-'" + mechanism.points[q].name +
        "' is not that of the nominal positions, but a fixed joint joins it to other points; "
        "give nominal positions with that length");
  }
  for (Derived& x : line) x = x * (*part.length / drawn);
  // Without vectors the frame is free. Its x axis along the line takes the length unrounded.
  if (body.vectors.empty()) line = {*part.length, 0, 0};
  body.own_points = {{p, drawing.origin()}, {q, line}};
  for (const int v : body.vectors) body.own_vectors[v] = drawing.vector(v);
}

/// Finds the own shape of a rigid body whose drawing is an estimate: with a stated length, or with
/// a frame of its own.
void find_shape(const Mechanism& mechanism, RigidBody& body) {
  for (const int b : body.bodies) {
    const Mechanism::Body& part = mechanism.bodies[b];
    if (part.length) state_length(mechanism, part, body);
    if (!part.own) continue;  // a body with its own frame has no fixed joint: it is alone
    for (std::size_t k = 0; k < part.points.size(); ++k)
      body.own_points[part.points[k]] = part.own->points[k];
    for (std::size_t k = 0; k < part.vectors.size(); ++k)
      body.own_vectors[part.vectors[k]] = part.own->vectors[k];
  }
}

/// Refuses a body whose basis is drawn as the mirror image of its own shape, or without volume. Its
/// equations, of lengths and angles, also hold for the mirror image. Assembly keeps the hand of the
/// drawing, because a basis without volume is singular.
void require_same_hand(const Mechanism& mechanism, const RigidBody& body) {
  if (!body.has_shape() || body.basis.directions.size() < 3) return;
  const BodyDrawing<double> drawing{mechanism};
  const auto volume = [&](auto&& direction) {
    const auto& basis = body.basis.directions;
    return dot(direction(basis[0]), cross(direction(basis[1]), direction(basis[2])));
  };
  if (volume([&](const auto& x) { return drawing.direction(x); }) *
          volume([&](const auto& x) { return drawing.direction(body, x); }) <=
      0)
    throw std::invalid_argument("body '" + mechanism.bodies[body.bodies.front()].name +
                                "': with what other bodies place, its points and vectors stand as "
                                "in a mirror; place it more "
                                "exactly by \"at\"");
}

}  // namespace

bool Basis::has_point(int point) const {
  return point == origin || std::ranges::any_of(directions, [&](const auto& d) {
           return d.is_line() && d.to == point;
         });
}

bool Basis::has_vector(int vector) const {
  return std::ranges::any_of(directions,
                             [&](const auto& d) { return !d.is_line() && d.vector == vector; });
}

bool follows_from_points(const Mechanism& mechanism, const RigidBody& body, int vector) {
  if (mechanism.bodies[body.bodies.front()].own) return false;  // its own frame gives the vector
  const auto& along = mechanism.vectors[vector].along;
  const auto carries = [&](int point) {
    return std::ranges::find(body.points, point) != body.points.end();
  };
  return along && carries((*along)[0]) && carries((*along)[1]);
}

void require_representable(const Mechanism& mechanism) {
  for (const Mechanism::Body& body : mechanism.bodies) {
    if (&body == &mechanism.bodies.front()) continue;  // the ground, whose points are constants
    if (body.length) require_representable(body.length->value, body.name);
    const std::vector<Vec> points = shape_of(mechanism, body);
    for (const Vec& p : points)
      require_representable(
          std::hypot(p[0] - points[0][0], p[1] - points[0][1], p[2] - points[0][2]), body.name);
  }
}

RigidBodies find_rigid_bodies(const Mechanism& mechanism) {
  RigidBodies rigid;
  DisjointSets fixed = fixed_bodies(mechanism);
  rigid.of_body.resize(mechanism.bodies.size());
  for (int b = 0; b < static_cast<int>(mechanism.bodies.size()); ++b) {
    const int first = fixed.find(b);
    if (first == b) {
      rigid.of_body[b] = static_cast<int>(rigid.list.size());
      rigid.list.emplace_back();
    }
    rigid.of_body[b] = rigid.of_body[first];
    rigid.list[rigid.of_body[b]].bodies.push_back(b);
  }
  rigid.of_point.resize(mechanism.points.size());
  rigid.of_vector.resize(mechanism.vectors.size());
  for (int r = 0; r < static_cast<int>(rigid.list.size()); ++r) {
    RigidBody& body = rigid.list[r];
    for (const int b : body.bodies) {
      const Mechanism::Body& part = mechanism.bodies[b];
      list_carried(part.points, r, body.points, rigid.of_point);
      list_carried(part.vectors, r, body.vectors, rigid.of_vector);
    }
    find_shape(mechanism, body);
    if (r == 0) continue;
    body.basis = choose_basis(mechanism, body);
    require_same_hand(mechanism, body);
    body.freedoms = count_freedoms(mechanism.dimension, body.basis);
    if (body.freedoms == 0)
      throw std::invalid_argument("body '" + mechanism.bodies[body.bodies.front()].name +
                                  "' carries no point and no vector: nothing can tell where it is; "
                                  "list some in it, or leave it out");
  }
  return rigid;
}

}  // namespace desmo
