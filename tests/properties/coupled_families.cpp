// Mechanisms with couplings, linear and by tables, some of which repeat.
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include "tests/properties/mechanisms.h"
#include "tests/properties/plane_builder.h"

namespace desmo::properties {

namespace {

using Vec = Mechanism::Vec;
using Coupling = Mechanism::Coupling;

/// Two links that begin at a and at c, and where they meet.
struct Dyad {
  double from_a, from_c;
  Vec joint;
};
Dyad drawn_dyad(Random& r, const Vec& a, const Vec& c) {
  const double to = length_between(a, c);
  const double sum = to * r.uniform(1.2, 3), difference = to * r.uniform(-0.8, 0.8);
  const double from_a = (sum + difference) / 2, from_c = (sum - difference) / 2;
  return {from_a, from_c, meeting(a, from_a, c, from_c, r.sign())};
}

/// A table over a turn that repeats, or over several turns. Its values vary about a rise a turn.
Coupling::Table drawn_table(Random& r, double rise, double size) {
  const bool repeats = r.chance(0.7);
  const double first = repeats ? 0 : -24, last = repeats ? 2 * std::numbers::pi : 24;
  Coupling::Table table{.arguments = {}, .values = {}, .from = std::nullopt};
  table.ends = !repeats    ? r.chance(0.5) ? SplineEnds::natural : SplineEnds::clamped
               : rise == 0 ? SplineEnds::periodic
                           : SplineEnds::indexing;
  const int n = repeats ? 3 + r.below(6) : 12 + r.below(30);
  for (int i = 0; i <= n; ++i) {
    const bool at_end = i == 0 || i == n;
    const double at = first + (last - first) * (i + (at_end ? 0 : r.uniform(-0.3, 0.3))) / n;
    table.arguments.push_back(at);
    table.values.push_back(rise * at / (2 * std::numbers::pi) +
                           (at_end ? 0 : size * r.uniform(-1, 1)));
  }
  if (repeats) table.values.back() = rise;
  return table;
}

Coupling::Term term(Random& r, int coordinate) {
  const int sign = r.sign();
  return {coordinate, sign * (1.0 + r.below(5))};
}

/// Returns the pin of a crank that turns about a pivot.
Vec drawn_pin(Random& r, const Vec& pivot) {
  const double angle = r.uniform(-3, 3);
  return polar(pivot, r.uniform(0.3, 1), angle);
}

/// Cranks OA and DB of which one is geared to the other, and maybe to coupler AC.
Drawn geared_five_bar(Random& r) {
  const double base = r.uniform(0.5, 3);
  const Vec d{base, 0, 0}, a = drawn_pin(r, {}), b = drawn_pin(r, d);
  const Dyad dyad = drawn_dyad(r, a, b);
  PlaneBuilder p("geared_five_bar", {{"O", {}}, {"D", d}, {"A", a}, {"B", b}, {"C", dyad.joint}},
                 {"O", "D"});
  p.link("O", "A"), p.link("D", "B"), p.link("A", "C"), p.link("B", "C");
  p.drive_angle("O", "A");
  p.angle("b", "D", "B"), p.angle("c", "A", "C");
  std::vector<Coupling::Term> terms{term(r, 0), term(r, 1)};
  if (r.chance(0.5)) terms.push_back(term(r, 2));
  p.builder().couple("mesh", terms);
  return {p.release(), {1.0}, 6.3};
}

/// A four-bar whose crank WB follows a shaft OA, or the shaft follows the crank.
Drawn indexed_four_bar(Random& r) {
  const Vec w{r.uniform(-3, 3), 0, 0}, b = drawn_pin(r, w), g{w[0] + r.uniform(1, 3), 0, 0};
  const Dyad dyad = drawn_dyad(r, b, g);
  PlaneBuilder p("indexed_four_bar",
                 {{"O", {}}, {"A", {1, 0, 0}}, {"W", w}, {"B", b}, {"G", g}, {"C", dyad.joint}},
                 {"O", "W", "G"});
  p.link("O", "A"), p.link("W", "B"), p.link("B", "C"), p.link("G", "C");
  p.drive_angle("O", "A");
  p.angle("w", "W", "B");
  Mechanism m = p.release();
  const bool inverse = r.chance(0.3);
  const double turn = r.sign() * 2 * std::numbers::pi, rise = turn / (inverse ? 1 : 1 + r.below(4));
  m.couplings.push_back({"index",
                         {{inverse ? 0 : 1, 1}, {inverse ? 1 : 0, 1}},
                         drawn_table(r, rise, inverse ? 0.1 : r.uniform(0.05, 1))});
  return {std::move(m), {1.0}, 6.3};
}

/// A follower F of a cam OA, or of a pinion, that moves a rocker GK.
Drawn cam_rocker(Random& r) {
  const Vec f{0, r.uniform(0.5, 2), 0}, g{r.uniform(0.5, 2), r.uniform(-1, 2), 0};
  const Dyad dyad = drawn_dyad(r, f, g);
  PlaneBuilder p("cam_rocker", {{"O", {}}, {"A", {1, 0, 0}}, {"F", f}, {"G", g}, {"K", dyad.joint}},
                 {"O", "G"});
  const int y = p.ground_vector("y", {0, 1, 0});
  p.link("O", "A");
  p.slide("F", p.link("F", "K"), "O", y);
  p.link("G", "K");
  p.drive_angle("O", "A");
  p.drive_along("O", "F", y);
  Mechanism m = p.release();
  m.coordinates.back().driven = false;
  const double lift = r.uniform(0.1, 0.5) * length_between(f, g);
  Coupling cam{"cam", {{1, 1}, {0, 1}}, {}};
  if (r.chance(0.3))
    cam.terms[1].factor = r.sign() * lift;
  else
    cam.table = drawn_table(r, 0, lift);
  m.couplings.push_back(std::move(cam));
  return {std::move(m), {1.0}, 6.3};
}

}  // namespace

std::span<const Family> coupled_families() {
  static constexpr Family all[] = {
      {"geared_five_bar", geared_five_bar},
      {"indexed_four_bar", indexed_four_bar},
      {"cam_rocker", cam_rocker},
  };
  return all;
}

}  // namespace desmo::properties
