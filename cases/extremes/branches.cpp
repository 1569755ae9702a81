// Row 5: steps so large, or starts so far off, that another branch is near.
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

namespace {

std::string steps(const char* of, double step, const char* unit) {
  return formatted("%s, steps of %g %s", of, step, unit);
}

ExtremeCase four_bar_in(double step) {
  return may_fail(case_of(steps("four-bar, K = 3", step, "rad"), usual_chain(3, chain_start), 1,
                          {0, step, 31}));
}

ExtremeCase library_in(std::string_view name, std::string case_name, double step, int instants) {
  Scene scene = library_scene(name);
  scene.grid = {0, step, instants};
  return may_fail({.name = std::move(case_name), .scene = std::move(scene)});
}

/// Makes the Stewart platform drawn beneath its base, mirrored at the base's plane. The same
/// lengths of the legs allow this position.
ExtremeCase platform_beneath(double step) {
  ExtremeCase c =
      library_in("stewart", steps("Stewart platform beneath its base", step, "s"), step, 9);
  Mechanism& mechanism = c.scene.mechanism;
  const auto mirror = [](Mechanism::Vec& v, auto& r) { v[2] = -v[2], r[2].correction *= -1; };
  for (Mechanism::Point& p : mechanism.points)
    mirror(p.position, p.remainder);  // the base stands at 0
  for (const Mechanism::Body& body : mechanism.bodies)
    if (body.name.starts_with("lower"))
      for (const int v : body.vectors)
        mirror(mechanism.vectors[v].direction, mechanism.vectors[v].remainder);
  return c;
}

/// Makes a four-bar of four equal links. Its crank turns back 0.012 rad before π, where both
/// branches are nearly one.
ExtremeCase folding_rhombus(double step) {
  const Motion there_and_back = HarmonicSum{2, {{1.13, 1, 0}}};
  ExtremeCase c =
      may_fail(case_of(steps("folding rhombus", step, "s"), std::vector{one_dyad(2, 2, 2, 2, 2)},
                       {there_and_back}, {0, step, 31}));
  c.factor = 100;  // wider than usual: the instants near π are nearly singular
  return c;
}

}  // namespace

std::vector<ExtremeCase> branches(Extent extent) {
  std::vector<ExtremeCase> all;
  for (const double step : {0.01, 0.1, 0.5, 1.0, 2.0, 3.0}) all.push_back(four_bar_in(step));
  all.push_back(
      library_in("andrews", "Andrews' mechanism, steps of 3 rad", 3 / (2 * std::numbers::pi), 11));
  for (const double step : {0.25, 1.0})
    all.push_back(library_in("stewart", steps("Stewart platform", step, "s"), step, 9));
  all.push_back(platform_beneath(0.25));
  for (const double step : {0.05, 0.5}) all.push_back(folding_rhombus(step));
  ExtremeCase anywhere = may_fail(
      case_of("four-bar, K = 2, from anywhere", usual_chain(2, chain_start), 1, {0, 1, 1}));
  anywhere.starts = {extent == Extent::brief ? 200 : 2000, 1};
  all.push_back(anywhere);
  return all;
}

}  // namespace desmo::extremes
