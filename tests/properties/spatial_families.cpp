#include <cmath>
#include <string>

#include "cases/extremes/rows.h"
#include "cases/mechanism/builder.h"
#include "cases/numbers/space.h"
#include "tests/properties/mechanisms.h"

namespace desmo::properties {

namespace {

using Vec = Mechanism::Vec;
using enum Mechanism::JointType;
constexpr int ground = MechanismBuilder::ground;

Vec combined(double a, const Vec& x, double b, const Vec& y, double c = 0, const Vec& z = {}) {
  Vec v;
  for (int i = 0; i < 3; ++i) v[i] = a * x[i] + b * y[i] + c * z[i];
  return v;
}
Vec unit(const Vec& a) { return combined(1 / std::sqrt(dot(a, a)), a, 0, a); }
Vec random_direction(Random& r) {
  const double z = r.uniform(-1, 1), angle = r.uniform(-3, 3), s = std::sqrt(1 - z * z);
  return {s * std::cos(angle), s * std::sin(angle), z};
}
/// A unit vector at a right angle.
Vec across(const Vec& a) {
  return unit(cross(a, std::abs(a[0]) < 0.7 ? Vec{1, 0, 0} : Vec{0, 1, 0}));
}

/// A driven angle: direction `of` in the plane of u and v of the ground, where 0 is along u.
void drive(MechanismBuilder& b, const Mechanism::Direction& of, const Vec& zero, const Vec& axis) {
  const int u = b.vector("u", zero), v = b.vector("v", cross(axis, zero));
  b.carry(ground, {}, {u, v});
  b.angle("theta", of, {u}, {v}).driven = true;
}

/// A crank OA about an axis through the origin, and a rod AB; returns the builder, B and the rod.
struct Start {
  MechanismBuilder builder;
  int tip, rod;
};
Start crank_and_rod(const std::string& name, Random& r, const Vec& tip) {
  Start s{MechanismBuilder(name, 3), 0, 0};
  MechanismBuilder& b = s.builder;
  b.set_length_unit("1");
  const Vec axis{0, 0, 1}, zero{1, 0, 0}, arm = turned_about(axis, r.uniform(-0.8, 0.8), zero);
  const int o = b.point("O", {}), a = b.point("A", combined(r.uniform(0.2, 0.6), arm, 0, arm));
  s.tip = b.point("B", tip);
  const int z = b.vector("z", axis), crank = b.body("crank", {o, a}, {z});
  b.carry(ground, {o}, {z});
  s.rod = b.body("rod", {a, s.tip});
  b.joint(revolute, ground, crank, {o}, {z});
  b.joint(spherical, crank, s.rod, {a});
  drive(b, {-1, o, a}, zero, axis);
  return s;
}

Drawn bennett(Random& r) {
  const double alpha = r.uniform(0.3, 1.2), beta = r.uniform(1.3, 2.4), a = r.uniform(0.5, 1.5);
  MechanismBuilder b("bennett", 3);
  b.set_length_unit("1");
  extremes::add_linkage(b, extremes::bennett_links(r.uniform(0.6, 2.4), a, alpha, beta));
  return {b.release(), {1.0}, 1};
}

Drawn spherical_four_bar(Random& r) {
  MechanismBuilder b("spherical_four_bar", 3);
  b.set_length_unit("1");
  const Vec first{0, 0, 1}, zero{1, 0, 0}, arm = turned_about(first, r.uniform(-0.8, 0.8), zero);
  const double short_arc = r.uniform(0.2, 0.7);
  const Vec second = combined(std::cos(short_arc), first, std::sin(short_arc), arm);
  const int o = b.point("O", {}), p = b.point("P", second);
  const int axes[] = {b.vector("a", first), b.vector("b", second),
                      b.vector("c", random_direction(r)), b.vector("d", random_direction(r))};
  const int m = b.vector("m", arm);
  const int crank = b.body("crank", {o, p}, {axes[0], axes[1], m});
  const int coupler = b.body("coupler", {o}, {axes[1], axes[2]});
  const int rocker = b.body("rocker", {o}, {axes[2], axes[3]});
  b.carry(ground, {o}, {axes[3], axes[0]});
  b.joint(revolute, ground, crank, {o}, {axes[0]});
  b.joint(revolute, crank, coupler, {o}, {axes[1]});
  b.joint(revolute, coupler, rocker, {o}, {axes[2]});
  b.joint(revolute, rocker, ground, {o}, {axes[3]});
  drive(b, {m, -1, -1}, zero, first);
  return {b.release(), {1.0}, 1};
}

/// RSSR.
Drawn spatial_four_bar(Random& r) {
  const Vec towards = random_direction(r), pivot = combined(r.uniform(0.8, 1.5), towards, 0, {});
  const Vec axis = random_direction(r), tip = combined(1, pivot, r.uniform(0.5, 1), across(axis));
  Start s = crank_and_rod("spatial_four_bar", r, tip);
  MechanismBuilder& b = s.builder;
  const int c = b.point("C", pivot), w = b.vector("w", axis);
  const int rocker = b.body("rocker", {c, s.tip}, {w});
  b.carry(ground, {c}, {w});
  b.joint(spherical, s.rod, rocker, {s.tip});
  b.joint(revolute, rocker, ground, {c}, {w});
  return {b.release(), {1.0}, 1};
}

Drawn rssp(Random& r) {
  const Vec axis = random_direction(r), towards = random_direction(r),
            base = combined(r.uniform(0, 0.4), towards, 0, {});
  Start s = crank_and_rod("rssp", r, combined(1, base, r.uniform(0.9, 2), axis));
  MechanismBuilder& b = s.builder;
  const int c = b.point("C", base), w = b.vector("w", axis), n = b.vector("n", across(axis));
  const int slider = b.body("slider", {s.tip}, {w, n});
  b.carry(ground, {c}, {w, n});
  b.joint(spherical, s.rod, slider, {s.tip});
  b.joint(prismatic, ground, slider, {c, s.tip}, {w, n});
  b.along("stroke", c, s.tip, w);
  return {b.release(), {1.0}, 1};
}

Drawn hooke_joint(Random& r) {
  MechanismBuilder b("hooke_joint", 3);
  b.set_length_unit("1");
  const Vec axis{0, 0, 1}, zero{1, 0, 0}, arm = turned_about(axis, r.uniform(-0.8, 0.8), zero);
  const double bend = r.uniform(0.1, 1.5);
  const Vec driven = turned_about(turned_about(axis, r.uniform(-3, 3), zero), bend, axis);
  const int o = b.point("O", {}), p = b.point("P", unit(cross(driven, arm)));
  const int a = b.vector("a", axis), d = b.vector("d", driven);
  const int c = b.vector("c", arm), e = b.vector("e", unit(cross(driven, arm)));
  b.carry(ground, {o}, {a, d});
  const int first = b.body("first", {o}, {a, c}), second = b.body("second", {o, p}, {d, e});
  b.joint(revolute, ground, first, {o}, {a});
  b.joint(revolute, ground, second, {o}, {d});
  b.joint(universal, first, second, {o}, {c, e});
  drive(b, {c, -1, -1}, zero, axis);
  return {b.release(), {1.0}, 1};
}

}  // namespace

std::span<const Family> spatial_families() {
  static constexpr Family all[] = {
      {"bennett", bennett},
      {"spherical_four_bar", spherical_four_bar},
      {"spatial_four_bar", spatial_four_bar},
      {"rssp", rssp},
      {"hooke_joint", hooke_joint},
  };
  return all;
}

}  // namespace desmo::properties
