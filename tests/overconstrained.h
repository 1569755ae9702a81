#pragma once

#include <array>
#include <cmath>
#include <cstdlib>
#include <string>
#include <tuple>

#include "cases/extremes/rows.h"
#include "cases/mechanism/directions.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/scene.h"
#include "cases/numbers/space.h"

namespace desmo {

/// Returns the double nearest to a number that is typed with so many digits.
inline double typed(long double x, int digits) {
  return std::strtod(formatted("%.*Lg", digits, x).c_str(), nullptr);
}

/// Bennett's linkage, which moves only if its twists and lengths match, drawn with its crank at
/// `start`. Its numbers are computed with more digits than typed.
inline Scene bennett(long double start, int digits, long double size = 1,
                     long double from_origin = 0) {
  using Vec = std::array<long double, 3>;
  const long double twists[] = {0.7L, 1.6L};
  const long double lengths[] = {size, size * std::sin(twists[1]) / std::sin(twists[0])};
  const long double ratio =
      std::sin((twists[1] + twists[0]) / 2) / std::sin((twists[1] - twists[0]) / 2);
  const long double other = 2 * std::atan(ratio / std::tan(start / 2));
  const long double angles[] = {start, other, -start, -other};
  const auto all_typed = [&](const Vec& v) -> Mechanism::Vec {
    return {typed(v[0], digits), typed(v[1], digits), typed(v[2], digits)};
  };
  MechanismBuilder builder("bennett", 3);
  Vec x{1, 0, 0}, z{0, 0, 1}, at{from_origin, from_origin, 0};
  std::array<int, 4> p, v;
  for (int i = 0; i < 4; ++i) {
    p[i] = builder.point("P" + std::to_string(i + 1), all_typed(at));
    v[i] = builder.vector("z" + std::to_string(i + 1), *unit_vector(all_typed(z)));
    x = turned_about(z, angles[i], x);
    for (int k = 0; k < 3; ++k) at[k] += lengths[i % 2] * x[k];
    z = turned_about(x, twists[i % 2], z);
  }
  const int from = builder.vector("x", {1, 0, 0}), towards = builder.vector("y", {0, 1, 0});
  extremes::hinge_loop(builder, "link", p, v, from, towards);
  const Motion crank = Polynomial{{static_cast<double>(start), 1}};
  return {"bennett", builder.release(), {crank}, {0, 0.05, 21}};
}

/// Three parallel cranks of 0.7 carry a coupler, where two would do. The third one is longer by
/// `longer`; the drawing closes. Lengths are stated or those of the drawing.
inline Scene parallel_cranks(long double start, int digits, bool stated, long double longer = 0,
                             long double size = 1, long double from_origin = 0) {
  using enum Mechanism::JointType;
  constexpr long double length = 0.7L,
                        along = 0.3L;  // length of a crank; direction of the base [rad]
  MechanismBuilder builder("parallel_cranks", 2);
  const int coupler = builder.body("coupler", {});
  for (const auto& [number, pivot, more] :
       {std::tuple{1, 0.L, 0.L}, std::tuple{2, 2.1L, 0.L}, std::tuple{3, 4.7L, longer}}) {
    const std::string name = std::to_string(number);
    const long double c = std::cos(start), s = std::sin(start);
    const long double x = from_origin + size * pivot * std::cos(along),
                      y = from_origin + size * pivot * std::sin(along);
    const long double l = size * (length + more);
    const int b = builder.point("B" + name, {typed(x + size * length * c, digits),
                                             typed(y + size * length * s, digits), 0});
    const int a = builder.point("A" + name, {typed(x + size * length * c - l * c, digits),
                                             typed(y + size * length * s - l * s, digits), 0});
    builder.carry(MechanismBuilder::ground, {a});
    builder.carry(coupler, {b});
    const int crank = stated ? builder.link("crank" + name, a, b, typed(l, digits))
                             : builder.body("crank" + name, {a, b});
    builder.joint(revolute, MechanismBuilder::ground, crank, {a});
    builder.joint(revolute, crank, coupler, {b});
    if (number == 1) builder.angle("theta", {-1, a, b}).driven = true;
  }
  const Motion crank = Polynomial{{static_cast<double>(start), 1}};
  return {"parallel_cranks", builder.release(), {crank}, {0, 0.05, 21}};
}

}  // namespace desmo
