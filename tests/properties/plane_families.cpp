#include <cmath>
#include <string>

#include "tests/properties/mechanisms.h"
#include "tests/properties/plane_builder.h"

namespace desmo::properties {

namespace {

using Vec = Mechanism::Vec;
using enum Mechanism::JointType;

/// A multiple of 1/8, which adds up exactly.
double eighths(Random& random, int from, int to) {
  return (from + random.below(to - from + 1)) / 8.0;
}

/// A crank whose length and nominal pin are exact, so that all of the model is.
struct ExactCrank {
  double length;
  Vec pin;
};
ExactCrank exact_crank(Random& r) {
  static constexpr double triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
  const auto& t = r.pick(triples);
  const double unit = std::ldexp(1, -r.below(3) - 3);
  return {t[2] * unit, {r.sign() * t[0] * unit, t[1] * unit, 0}};
}

/// Crank AB, coupler BC, rocker DC.
Mechanism closed_four_bar(std::string name, double crank, double coupler, double rocker,
                          double base, const Vec& b, const Vec& c) {
  PlaneBuilder p(std::move(name), {{"A", {}}, {"D", {base, 0, 0}}, {"B", b}, {"C", c}}, {"A", "D"});
  p.link("A", "B", crank), p.link("B", "C", coupler), p.link("D", "C", rocker);
  p.drive_angle("A", "B");
  return p.release();
}

Drawn four_bar(Random& r) {
  const double crank = r.uniform(0.3, 3), base = r.uniform(0.3, 3);
  const Vec b = polar({}, crank, r.uniform(-3, 3)), d{base, 0, 0};
  const double to = length_between(b, d);
  const double sum = to * r.uniform(1.1, 2.5), difference = to * r.uniform(-0.9, 0.9);
  const double coupler = (sum + difference) / 2, rocker = (sum - difference) / 2;
  Mechanism m = closed_four_bar("four_bar", crank, coupler, rocker, base, b,
                                meeting(b, coupler, d, rocker, r.sign()));
  Mechanism::Coordinate psi = m.coordinates.front();
  psi.name = "psi";
  psi.of = {-1, 1, 3};
  psi.driven = false;
  m.coordinates.push_back(psi);
  return {std::move(m), {1.0}, 6.3};
}

/// A four-bar whose dimensions and nominal position are exact.
Drawn exact_four_bar(std::string name, double crank, double coupler, double rocker, double base,
                     const Vec& b, const Vec& c) {
  return {closed_four_bar(std::move(name), crank, coupler, rocker, base, b, c), {1.0}, 4, true};
}

Drawn parallelogram(Random& r) {
  const auto [crank, b] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  return exact_four_bar("parallelogram", crank, base, crank, base, b, {b[0] + base, b[1], 0});
}

Drawn antiparallelogram(Random& r) {
  const auto [crank, b] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  return exact_four_bar("antiparallelogram", crank, base, crank, base, b,
                        meeting(b, base, {base, 0, 0}, crank, -1));
}

/// Crank as long as the base, coupler as long as the rocker.
Drawn deltoid(Random& r) {
  const auto [base, b] = exact_crank(r);
  const double rocker = base + eighths(r, 1, 16);
  return exact_four_bar("deltoid", base, rocker, rocker, base, b,
                        meeting(b, rocker, {base, 0, 0}, rocker, r.sign()));
}

/// Crank and half of a bar whose end slides through the pivot.
Drawn scott_russell(Random& r) {
  const auto [crank, m] = exact_crank(r);
  PlaneBuilder p("scott_russell", {{"O", {}}, {"M", m}, {"C", {0, 2 * m[1], 0}}}, {"O"});
  const int y = p.ground_vector("y", {0, 1, 0});
  p.link("O", "M", crank);
  p.slide("C", p.link("M", "C", crank), "O", y);
  p.drive_angle("O", "M");
  p.angle("phi", "M", "C");
  return {p.release(), {1.0}, 3, true};
}

/// Crank OM, rod MC, whose end slides on a line that passes the pivot at a distance.
Mechanism sliding(std::string name, Random& r, bool crank_drives) {
  const double crank = r.uniform(0.3, 2), rod = crank * r.uniform(1.2, 4);
  const double offset = r.chance(0.3) ? 0 : crank * r.uniform(-0.15, 0.15);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(0.5, 2.6)), e{0, offset, 0};
  const double rise = m[1] - offset, run = std::sqrt(rod * rod - rise * rise);
  PlaneBuilder p(std::move(name), {{"O", o}, {"E", e}, {"M", m}, {"C", {m[0] + run, offset, 0}}},
                 {"O", "E"});
  const int x = p.ground_vector("x", {1, 0, 0});
  p.link("O", "M", crank);
  p.slide("C", p.link("M", "C", rod), "E", x);
  if (crank_drives) p.drive_angle("O", "M");
  p.drive_along("E", "C", x);
  Mechanism result = p.release();
  result.coordinates.back().driven = !crank_drives;
  return result;
}

Drawn offset_slider_crank(Random& r) {
  return {sliding("offset_slider_crank", r, true), {1.0}, 6.3};
}

Drawn driven_slider(Random& r) { return {sliding("driven_slider", r, false), {1.0}, 4}; }

/// The rod slides through a block that turns.
Drawn oscillating_block(Random& r) {
  const double crank = r.uniform(0.3, 2);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(0.3, 2.8));
  const Vec g{r.chance(0.2) ? crank : crank * r.uniform(0.5, 3), 0, 0};
  PlaneBuilder p("oscillating_block", {{"O", o}, {"G", g}, {"M", m}}, {"O", "G"});
  p.link("O", "M", crank);
  const int rod = p.body("rod", {"M"});
  MechanismBuilder& b = p.builder();
  const double length = length_between(m, g);
  const int u = b.vector("u", {(g[0] - m[0]) / length, (g[1] - m[1]) / length, 0});
  b.carry(rod, {}, {u});
  b.joint(revolute_on_slider, rod, MechanismBuilder::ground, {p.index("M"), p.index("G")}, {u});
  p.drive_angle("O", "M");
  b.along("s", p.index("M"), p.index("G"), u);
  return {p.release(), {1.0}, 6.3};
}

/// A bar whose ends slide on two lines, one end driven.
Drawn trammel(Random& r) {
  const double length = eighths(r, 8, 24), angle = r.uniform(0.3, 1.2);
  PlaneBuilder p(
      "trammel",
      {{"O", {}}, {"P", {length * std::cos(angle), 0, 0}}, {"Q", {0, length * std::sin(angle), 0}}},
      {"O"});
  const int x = p.ground_vector("x", {1, 0, 0}), y = p.ground_vector("y", {0, 1, 0});
  const int bar = p.link("P", "Q", length);
  p.slide("P", bar, "O", x);
  p.slide("Q", bar, "O", y);
  p.drive_along("O", "P", x);
  return {p.release(), {1.0}, 3, true};
}

Drawn peaucellier(Random& r) {
  const double crank = eighths(r, 4, 8), arm = 2.5 * crank,
               side = crank * (1.25 + 0.125 * r.below(5));
  const Vec g{crank, 0, 0}, o{0, 0, 0}, c = polar(g, crank, r.uniform(-0.8, 0.8));
  const Vec a = meeting(o, arm, c, side, 1), b = meeting(o, arm, c, side, -1);
  const Vec q{a[0] + b[0] - c[0], a[1] + b[1] - c[1], 0};
  PlaneBuilder p("peaucellier", {{"O", o}, {"G", g}, {"P", c}, {"A", a}, {"B", b}, {"Q", q}},
                 {"O", "G"});
  p.link("G", "P", crank), p.link("O", "A", arm), p.link("O", "B", arm);
  p.link("P", "A", side), p.link("P", "B", side), p.link("Q", "A", side), p.link("Q", "B", side);
  p.drive_angle("G", "P");
  return {p.release(), {1.0}, 3};
}

Drawn chebyshev(Random& r) {
  const double unit = r.uniform(0.2, 1.5), theta = r.uniform(1.0, 1.9);
  const Vec a{0, 0, 0}, d{4 * unit, 0, 0}, b = polar(a, 5 * unit, theta);
  const Vec c = meeting(b, 2 * unit, d, 5 * unit, r.sign());
  const Vec middle{(b[0] + c[0]) / 2, (b[1] + c[1]) / 2, 0};
  PlaneBuilder p("chebyshev", {{"A", a}, {"D", d}, {"B", b}, {"C", c}, {"P", middle}}, {"A", "D"});
  p.link("A", "B");
  p.body("coupler", {"B", "C", "P"});
  p.link("D", "C");
  p.drive_angle("A", "B");
  return {p.release(), {1.0}, 2};
}

/// Two to eight parallelograms in a row.
Drawn two_loops(Random& r) {
  const auto [crank, pin] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  PlaneBuilder p("two_loops", {{"D0", {}}, {"C0", pin}}, {"D0"});
  p.link("D0", "C0", crank);
  const int loops = 2 + r.below(3) * r.below(3);
  for (int k = 1; k <= loops; ++k) {
    const std::string c = "C" + std::to_string(k), d = "D" + std::to_string(k);
    p.point(d, {base * k, 0, 0}), p.point(c, {pin[0] + base * k, pin[1], 0});
    p.ground({d});
    p.link("C" + std::to_string(k - 1), c, base), p.link(d, c, crank);
  }
  p.drive_angle("D0", "C0");
  return {p.release(), {1.0}, 4, true};
}

Drawn toggle_press(Random& r) {
  const double crank = r.uniform(0.2, 0.5), arm = r.uniform(1, 1.5), ram = r.uniform(1, 2);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(-3, 3));
  const Vec pivot{r.uniform(1.5, 2.5), r.uniform(0.8, 1.2), 0};
  const double to = length_between(m, pivot),
               coupler = std::abs(to - arm) + r.uniform(0.2, 0.9) * 2 * arm;
  const Vec knee = meeting(m, coupler, pivot, arm, r.sign());
  const double run = knee[0] - pivot[0];
  const Vec end{pivot[0], knee[1] - std::sqrt(std::max(0.01, ram * ram - run * run)), 0};
  PlaneBuilder p("toggle_press", {{"O", o}, {"M", m}, {"K", knee}, {"D", pivot}, {"R", end}},
                 {"O", "D"});
  const int y = p.ground_vector("y", {0, 1, 0});
  p.link("O", "M"), p.link("M", "K"), p.link("D", "K");
  p.slide("R", p.link("K", "R"), "D", y);
  p.drive_angle("O", "M");
  return {p.release(), {1.0}, 6.3};
}

}  // namespace

std::span<const Family> plane_families() {
  static constexpr Family all[] = {
      {"four_bar", four_bar},
      {"parallelogram", parallelogram},
      {"antiparallelogram", antiparallelogram},
      {"deltoid", deltoid},
      {"scott_russell", scott_russell},
      {"offset_slider_crank", offset_slider_crank},
      {"driven_slider", driven_slider},
      {"oscillating_block", oscillating_block},
      {"trammel", trammel},
      {"peaucellier", peaucellier},
      {"chebyshev", chebyshev},
      {"two_loops", two_loops},
      {"toggle_press", toggle_press},
  };
  return all;
}

}  // namespace desmo::properties
