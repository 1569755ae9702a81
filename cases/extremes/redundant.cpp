// Row 6: mechanisms with dependent constraints that move all the same, and variants in which a
// surplus constraint contradicts the others.
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <tuple>
#include <utility>

#include "cases/extremes/rows.h"
#include "cases/numbers/space.h"

namespace desmo::extremes {

namespace {

using enum Mechanism::JointType;
using Vec = Mechanism::Vec;

constexpr TimeGrid redundant_grid{0, 0.02, 51};

/// Makes three parallel cranks of length 1 that carry a coupler, where two would do. The second pin
/// of the coupler is shifted by `off` along x.
ExtremeCase parallel_cranks(std::string name, double off) {
  constexpr double start = 1;
  MechanismBuilder builder("parallel_cranks", 2);
  builder.set_length_unit("1");
  const int coupler = builder.body("coupler", {});
  for (const auto& [number, pivot, shift] :
       {std::tuple{1, 0.0, 0.0}, std::tuple{2, 2.0, off}, std::tuple{3, 5.0, 0.0}}) {
    const std::string name_of = std::to_string(number);
    const int a = builder.point("A" + name_of, {pivot, 0, 0});
    const int b =
        builder.point("B" + name_of, {pivot + std::cos(start) + shift, std::sin(start), 0});
    builder.carry(MechanismBuilder::ground, {a});
    builder.carry(coupler, {b});
    const int crank = builder.link("crank" + name_of, a, b, 1);
    builder.joint(revolute, MechanismBuilder::ground, crank, {a});
    builder.joint(revolute, crank, coupler, {b});
    if (number == 1) builder.angle("theta", {-1, a, b}).driven = true;
  }
  return {
      .name = std::move(name),
      .scene = {"parallel_cranks", builder.release(), {Polynomial{{start, 1}}}, redundant_grid}};
}

/// Makes Bricard's mechanism with right angles: six edges of a cube, hinged at its corners. The
/// fourth corner is shifted by `off` along z.
ExtremeCase bricard(std::string name, double off) {
  const std::array<Vec, 6> corners{
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1 + off}, {0, 1, 1}, {0, 0, 1}}};
  // Each axis is at right angles to both edges that it joins.
  constexpr std::array<Vec, 6> axes{
      {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}}};
  MechanismBuilder builder("bricard", 3);
  builder.set_length_unit("1");
  std::array<int, 6> p, v;
  for (int i = 0; i < 6; ++i) {
    p[i] = builder.point("P" + std::to_string(i + 1), corners[i]);
    v[i] = builder.vector("v" + std::to_string(i + 1), axes[i]);
  }
  const int from = builder.vector("x", {1, 0, 0}), towards = builder.vector("minus_z", {0, 0, -1});
  hinge_loop(builder, "edge", p, v, from, towards);
  return {.name = std::move(name),
          .scene = {"bricard", builder.release(), {Polynomial{{0, 0.5}}}, redundant_grid}};
}

/// Makes Bennett's mechanism, drawn with its crank at `start` [rad]. Where the crank is folded, at
/// π, some of the equations do not tell how the mechanism moves on.
ExtremeCase bennett(std::string name, double start, Polynomial motion, double tolerance = 1e-12) {
  MechanismBuilder builder("bennett", 3);
  builder.set_length_unit("1");
  add_linkage(builder, bennett_links(start, 1, 0.7, 1.6));
  return {
      .name = std::move(name),
      .scene =
          {"bennett", builder.release(), {std::move(motion)}, redundant_grid, {}, {}, tolerance},
      .factor = 100};  // wider than usual: equations near the folded position are dependent
}

}  // namespace

void hinge_loop(MechanismBuilder& builder, const std::string& body, std::span<const int> corners,
                std::span<const int> axes, int from, int towards) {
  const std::size_t n = corners.size();
  builder.carry(MechanismBuilder::ground, {corners[n - 1], corners[0]},
                {axes[n - 1], axes[0], from, towards});
  std::vector<int> bodies;
  for (std::size_t i = 0; i + 1 < n; ++i)
    bodies.push_back(builder.body(body + std::to_string(i + 1), {corners[i], corners[i + 1]},
                                  {axes[i], axes[i + 1]}));
  bodies.push_back(MechanismBuilder::ground);
  for (std::size_t i = 0; i < n; ++i)
    builder.joint(revolute, bodies[(i + n - 1) % n], bodies[i], {corners[i]}, {axes[i]});
  builder.angle("theta", {-1, corners[0], corners[1]}, {from}, {towards}).driven = true;
}

Mechanism::Vec add_linkage(MechanismBuilder& builder, std::span<const HingedLink> links) {
  Vec x{1, 0, 0}, z{0, 0, 1}, at{};
  std::vector<int> p, v;
  for (const auto& [angle, length, twist] : links) {
    const std::string number = std::to_string(p.size() + 1);
    p.push_back(builder.point("P" + number, at));
    v.push_back(builder.vector("z" + number, z));
    x = turned_about(z, angle, x);
    for (int k = 0; k < 3; ++k) at[k] += length * x[k];
    z = turned_about(x, twist, z);
  }
  const int from = builder.vector("x", {1, 0, 0}), towards = builder.vector("y", {0, 1, 0});
  hinge_loop(builder, "link", p, v, from, towards);
  return at;
}

std::array<HingedLink, 4> bennett_links(double start, double length, double twist,
                                        double other_twist) {
  const double other_length = length * std::sin(other_twist) / std::sin(twist);
  const double ratio = std::sin((other_twist + twist) / 2) / std::sin((other_twist - twist) / 2);
  const double other = 2 * std::atan(ratio / std::tan(start / 2));
  return {{{start, length, twist},
           {other, other_length, other_twist},
           {-start, length, twist},
           {-other, other_length, other_twist}}};
}

std::vector<ExtremeCase> redundant(Extent) {
  using std::numbers::pi;
  std::vector<ExtremeCase> all{
      parallel_cranks("three parallel cranks", 0),
      bricard("Bricard's mechanism", 0),
      bennett("Bennett's mechanism at rest where it is folded", pi, {{pi}}),
      bennett("Bennett's mechanism from there", pi, {{pi, 1}}),
      bennett("Bennett's mechanism past there", 2, {{pi - 0.505, 1}}),
      bennett("Bennett's mechanism to there", 2, {{pi - 1, 1}}),
      bennett("Bennett's mechanism to rest there", 2, {{pi - 1, 2, -1}}),
      bennett("Bennett's mechanism to a tolerance of 1e-15", 1, {{1, 1}}, 1e-15)};
  for (ExtremeCase& c : all) c.is_redundant = true;
  for (const ExtremeCase& c : {parallel_cranks("the cranks, contradictory by 0.01", 0.01),
                               bricard("Bricard's mechanism, contradictory by 0.01", 0.01)}) {
    all.push_back(c);
    all.back().is_refused = true;
  }
  return all;
}

}  // namespace desmo::extremes
