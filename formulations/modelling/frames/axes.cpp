// Vectors and points that are added to bodies: axes and origins of frames, normals.

#include <algorithm>
#include <cmath>

#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

namespace {

using Exact = AxisMaker::Exact;

/// Returns three orthonormal directions: the first one along the first direction of a body's basis,
/// and in space the second in the plane of the first two. exact: returns a direction.
template <class ExactDirection>
std::array<Exact, 3> axes_along(const Basis& basis, int dimension, const ExactDirection& exact) {
  const Exact x = unit_vector(exact(basis.directions.front()));
  if (dimension == 2) return {x, cross({0, 0, 1}, x), Exact{0, 0, 1}};
  const Exact y = unit_vector(across(exact(basis.directions[1]), x));
  return {x, y, cross(x, y)};
}

/// Returns whether a body with two directions has a point or vector off their plane. reach: largest
/// absolute nominal coordinate of a point
bool leaves_its_plane(const Mechanism& mechanism, const RigidBody& body, double reach) {
  const auto& directions = body.basis.directions;
  if (directions.size() != 2) return false;
  const BodyDrawing<double> drawing{mechanism};
  nominal::Vec normal =
      cross(drawing.direction(body, directions[0]), drawing.direction(body, directions[1]));
  const double length = nominal::norm(normal);
  for (double& x : normal) x /= length;
  const auto is_off = [&](const Mechanism::Direction& direction, double magnitude) {
    return !is_rounding(dot(normal, drawing.direction(body, direction)), magnitude);
  };
  reach = reach_of(mechanism, body, reach);
  const auto is_point_off = [&](int p) { return is_off({-1, body.basis.origin, p}, reach); };
  const auto is_vector_off = [&](int v) {
    return !follows_from_points(mechanism, body, v) && is_off({v}, 1);
  };
  return std::ranges::any_of(body.points, is_point_off) ||
         std::ranges::any_of(body.vectors, is_vector_off);
}

}  // namespace

std::set<std::string> names_in(const Mechanism& mechanism) {
  std::set<std::string> names;
  for (const auto& p : mechanism.points) names.insert(p.name);
  for (const auto& v : mechanism.vectors) names.insert(v.name);
  for (const auto& c : mechanism.coordinates) names.insert(c.name);
  return names;
}

std::string add_name(std::set<std::string>& names, const std::string& base) {
  std::string name = base;
  for (int n = 2; !names.insert(name).second; ++n) name = base + " " + std::to_string(n);
  return name;
}

AxisMaker::AxisMaker(FramedMechanism& framed)
    : framed_(framed), names_(names_in(framed.mechanism)) {}

Exact AxisMaker::own(int body, const Mechanism::Direction& d) const {
  return BodyDrawing<Derived>{framed_.mechanism}.direction(framed_.rigid.list[body], d);
}

std::array<Exact, 3> AxisMaker::own_axes(int body) const {
  if (body == 0) return {Exact{1, 0, 0}, Exact{0, 1, 0}, Exact{0, 0, 1}};
  return axes_along(framed_.rigid.list[body].basis, framed_.mechanism.dimension,
                    [&](const Mechanism::Direction& d) { return own(body, d); });
}

int AxisMaker::find_or_add_axis(int body, const Exact& direction, const char* what) {
  for (const int v : framed_.frames[body].axes)
    if (v >= 0 && are_same(own(body, v), direction)) return v;
  for (const int v : framed_.rigid.list[body].vectors)
    if (framed_.deriving_vector[v] == body && are_same(own(body, v), direction)) return v;
  return add_vector(body, direction, what);
}

std::pair<int, int> AxisMaker::find_or_add_normals(int body, int vector) {
  const Exact u = own(body, vector);
  // n: of the axis of the frame that is most nearly normal to u, the part normal to u.
  std::array<Exact, 3> axes = own_axes(body);
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (const int v = framed_.frames[body].axes[k]; v >= 0) axes[k] = own(body, v);
  Exact n = *std::ranges::min_element(
      axes, {}, [&](const Exact& axis) { return std::abs(dot(axis, u).value); });
  if (!are_normal(n, u)) n = unit_vector(across(n, u));
  const int first = find_or_add_axis(body, n, "normal");
  return {first, find_or_add_axis(body, cross(u, n), "normal")};
}

void AxisMaker::add_normal(int body) {
  auto& directions = framed_.rigid.list[body].basis.directions;
  const int normal = add_vector(body, own_axes(body)[2], "normal");
  directions.insert(std::ranges::find_if(directions, &Mechanism::Direction::is_line), {normal});
}

int AxisMaker::add_vector(int body, const Exact& own, const char* what) {
  Mechanism& mechanism = framed_.mechanism;
  RigidBody& rigid = framed_.rigid.list[body];
  const int v = static_cast<int>(mechanism.vectors.size());
  Mechanism::Vector& made = mechanism.vectors.emplace_back();
  made.name = unique_name(body, what);
  set_exact(made.direction, made.remainder, drawn(body, own));
  mechanism.bodies[rigid.bodies.front()].vectors.push_back(v);
  rigid.vectors.push_back(v);
  if (rigid.has_shape()) rigid.own_vectors[v] = own;
  framed_.rigid.of_vector.push_back({body});
  framed_.deriving_vector.push_back(body);
  return v;
}

int AxisMaker::add_point(int body, int place, const char* what) {
  Mechanism& mechanism = framed_.mechanism;
  RigidBody& rigid = framed_.rigid.list[body];
  const int p = static_cast<int>(mechanism.points.size());
  mechanism.points.push_back({unique_name(body, what), mechanism.points[place].position,
                              mechanism.points[place].remainder});
  mechanism.bodies[rigid.bodies.front()].points.push_back(p);
  rigid.points.push_back(p);
  if (rigid.has_shape()) rigid.own_points[p] = rigid.own_points.at(place);
  framed_.rigid.of_point.push_back({body});
  framed_.deriving.push_back(body);
  return p;
}

/// Returns a direction of a body's shape as it is drawn.
Exact AxisMaker::drawn(int body, const Exact& own) const {
  const RigidBody& rigid = framed_.rigid.list[body];
  if (!rigid.has_shape()) return own;
  const BodyDrawing<Derived> drawing{framed_.mechanism};
  const std::array<Exact, 3> of_shape = own_axes(body),
                             placed =
                                 axes_along(rigid.basis, framed_.mechanism.dimension,
                                            [&](const auto&d) { return drawing.direction(d); });
  Exact result{};
  for (int k = 0; k < 3; ++k) {
    const Derived along = dot(own, of_shape[k]);
    for (int i = 0; i < 3; ++i) result[i] = result[i] + along * placed[k][i];
  }
  return result;
}

std::string AxisMaker::unique_name(int body, const char* what) {
  const int first = framed_.rigid.list[body].bodies.front();
  return add_name(names_, framed_.mechanism.bodies[first].name + "/" + what);
}

std::optional<FramedMechanism> with_plane_normals(const Mechanism& mechanism,
                                                  const RigidBodies& rigid) {
  if (mechanism.dimension == 2) return {};
  const double reach = reach_of(mechanism);
  std::optional<FramedMechanism> result;
  for (int r = 1; r < static_cast<int>(rigid.list.size()); ++r) {
    if (!leaves_its_plane(mechanism, rigid.list[r], reach)) continue;
    if (!result) {
      result.emplace();
      result->mechanism = mechanism;
      result->rigid = rigid;
    }
    AxisMaker(*result).add_normal(r);
  }
  return result;
}

}  // namespace desmo
