#include "formulations/modelling/frames/axes.h"

#include <algorithm>
#include <cmath>

#include "cases/numbers/space.h"

namespace desmo {

using Exact = AxisMaker::Exact;

std::set<std::string> names_in(const Mechanism& d) {
  std::set<std::string> names;
  for (const auto& p : d.points) names.insert(p.name);
  for (const auto& v : d.vectors) names.insert(v.name);
  for (const auto& c : d.coordinates) names.insert(c.name);
  return names;
}

void set_exact(Mechanism::Vec& nearest, std::array<Remainder, 3>& remainder, const Exact& exact) {
  for (int i = 0; i < 3; ++i) {
    const Derived x = exact[i].rounded();
    nearest[i] = x.value;
    remainder[i] = x.remainder();
  }
}

Exact unit(const Exact& a) {
  const Derived length = sqrt(dot(a, a));
  return {a[0] / length, a[1] / length, a[2] / length};
}

Exact across(const Exact& a, const Exact& of) {
  const Derived along = dot(a, of);
  return {a[0] - along * of[0], a[1] - along * of[1], a[2] - along * of[2]};
}

bool are_same(const Exact& a, const Exact& b) {
  for (int i = 0; i < 3; ++i)
    if (!(std::abs((a[i] - b[i]).value) <= same_direction)) return false;
  return true;
}

bool are_normal(const Exact& a, const Exact& b) {
  return std::abs(dot(a, b).value) <= same_direction;
}

bool carries(const RigidBodies& rigid, int body, const Mechanism::Direction& d) {
  const auto has = [&](const std::vector<int>& carriers) {
    return std::ranges::binary_search(carriers, body);
  };
  return d.is_line() ? has(rigid.of_point[d.from]) && has(rigid.of_point[d.to])
                     : has(rigid.of_vector[d.vector]);
}

AxisMaker::AxisMaker(FramedMechanism& framed)
    : framed_(framed), names_(names_in(framed.mechanism)) {}

Exact AxisMaker::own(int body, const Mechanism::Direction& d) const {
  return BodyDrawing<Derived>{framed_.mechanism}.direction(framed_.rigid.list[body], d);
}

std::array<Exact, 3> AxisMaker::own_axes(int body) const {
  if (body == 0) return {Exact{1, 0, 0}, Exact{0, 1, 0}, Exact{0, 0, 1}};
  const auto& directions = framed_.rigid.list[body].basis.directions;
  const Exact x = unit(own(body, directions.front()));
  if (framed_.mechanism.dimension == 2) return {x, cross({0, 0, 1}, x), Exact{0, 0, 1}};
  const Exact y = unit(across(own(body, directions[1]), x));
  return {x, y, cross(x, y)};
}

int AxisMaker::find_or_add_axis(int body, const Exact& direction, const char* what) {
  for (const int v : framed_.frames[body].axes)
    if (v >= 0 && are_same(own(body, v), direction)) return v;
  for (const int v : framed_.rigid.list[body].vectors)
    if (framed_.deriving_vector[v] == body && are_same(own(body, v), direction)) return v;
  return add_vector(body, direction, what);
}

std::pair<int, int> AxisMaker::find_or_add_normals(int body, int vector) {
  const auto [at, is_new] = normals_.try_emplace({body, vector});
  if (!is_new) return at->second;
  const Exact u = own(body, vector);
  // n: of the axis of the frame that is most nearly normal to u, the part normal to u.
  std::array<Exact, 3> axes = own_axes(body);
  for (std::size_t k = 0; k < axes.size(); ++k)
    if (const int v = framed_.frames[body].axes[k]; v >= 0) axes[k] = own(body, v);
  Exact n = axes[0];
  for (const Exact& axis : axes)
    if (std::abs(dot(axis, u).value) < std::abs(dot(n, u).value)) n = axis;
  if (!are_normal(n, u)) n = unit(across(n, u));
  const int first = find_or_add_axis(body, n, "normal");
  return at->second = {first, find_or_add_axis(body, cross(u, n), "normal")};
}

Exact AxisMaker::nearest_to_normal(int body, const Exact& axis) const {
  Exact best{};
  double least = 2;
  for (const Mechanism::Direction& d : framed_.rigid.list[body].basis.directions) {
    const Exact u = unit(own(body, d));
    if (const double along = std::abs(dot(u, axis).value); along < least - 1e-9) {
      least = along;
      best = u;
    }
  }
  return best;
}

bool AxisMaker::measures_turn(const Mechanism::Coordinate& a, int parent, int body,
                              int axis) const {
  if (!carries(framed_.rigid, body, a.of)) return false;
  if (!a.from.is_given()) return parent == 0;
  if (!carries(framed_.rigid, parent, a.from)) return false;
  if (framed_.mechanism.dimension == 2) return true;
  if (!carries(framed_.rigid, parent, a.towards) || a.from.is_line() || a.towards.is_line())
    return false;
  const Exact u = own(parent, axis), f = own(parent, a.from), g = own(parent, a.towards);
  return are_normal(u, f) && are_normal(u, g) && are_normal(f, g) &&
         are_normal(own(body, axis), unit(own(body, a.of)));
}

void AxisMaker::add_normal(int body) {
  auto& directions = framed_.rigid.list[body].basis.directions;
  const int normal = add_vector(body, own_axes(body)[2], "normal");
  directions.insert(std::ranges::find_if(directions, &Mechanism::Direction::is_line), {normal});
}

int AxisMaker::add_vector(int body, const Exact& own, const char* what) {
  Mechanism& d = framed_.mechanism;
  RigidBody& rigid = framed_.rigid.list[body];
  const int v = static_cast<int>(d.vectors.size());
  Mechanism::Vector& made = d.vectors.emplace_back();
  made.name = unique_name(body, what);
  set_exact(made.direction, made.remainder, drawn(body, own));
  d.bodies[rigid.bodies.front()].vectors.push_back(v);
  rigid.vectors.push_back(v);
  if (rigid.has_shape()) rigid.own_vectors[v] = own;
  framed_.rigid.of_vector.push_back({body});
  framed_.deriving_vector.push_back(body);
  return v;
}

int AxisMaker::add_point(int body, int place, const char* what) {
  Mechanism& d = framed_.mechanism;
  RigidBody& rigid = framed_.rigid.list[body];
  const int p = static_cast<int>(d.points.size());
  d.points.push_back(
      {unique_name(body, what), d.points[place].position, d.points[place].remainder});
  d.bodies[rigid.bodies.front()].points.push_back(p);
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
  const std::array<Exact, 3> of_shape = own_axes(body);
  const BodyDrawing<Derived> drawing{framed_.mechanism};
  std::array<Exact, 3> placed;
  placed[0] = unit(drawing.direction(rigid.basis.directions.front()));
  if (framed_.mechanism.dimension == 2) {
    placed[2] = {0, 0, 1};
    placed[1] = cross(placed[2], placed[0]);
  } else {
    placed[1] = unit(across(drawing.direction(rigid.basis.directions[1]), placed[0]));
    placed[2] = cross(placed[0], placed[1]);
  }
  Exact result{};
  for (int k = 0; k < 3; ++k) {
    const Derived along = dot(own, of_shape[k]);
    for (int i = 0; i < 3; ++i) result[i] = result[i] + along * placed[k][i];
  }
  return result;
}

std::string AxisMaker::unique_name(int body, const char* what) {
  const int first = framed_.rigid.list[body].bodies.front();
  const std::string base = framed_.mechanism.bodies[first].name + "/" + what;
  std::string name = base;
  for (int n = 2; !names_.insert(name).second; ++n) name = base + " " + std::to_string(n);
  return name;
}

}  // namespace desmo
