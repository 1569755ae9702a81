// Mechanisms with more equations than they need, which may contradict each other.
#include <array>
#include <cmath>

#include "cases/mechanism/formatted.h"
#include "tests/properties/plane_builder.h"
#include "tests/properties/scene_kinds.h"

namespace desmo::properties {

namespace {

using Vec = Mechanism::Vec;

/// A coupler on three equal cranks. The third is longer, and its pivot further off, so that the
/// drawing closes: it is the only position that does.
Drawn three_cranks(Random& r, double longer) {
  const double crank = r.uniform(0.5, 2), angle = r.uniform(0.4, 2.6);
  const Vec e{std::cos(angle), std::sin(angle), 0};
  const double second = r.uniform(1, 2), third = second + r.uniform(1, 2);
  const auto pivot = [&](double x, double lengthened) {
    return Vec{x - lengthened * crank * e[0], -lengthened * crank * e[1], 0};
  };
  const auto pin = [&](double x) { return Vec{x + crank * e[0], crank * e[1], 0}; };
  PlaneBuilder p("three_cranks",
                 {{"D1", pivot(0, 0)},
                  {"D2", pivot(second, 0)},
                  {"D3", pivot(third, longer)},
                  {"C1", pin(0)},
                  {"C2", pin(second)},
                  {"C3", pin(third)}},
                 {"D1", "D2", "D3"});
  p.link("D1", "C1", crank), p.link("D2", "C2", crank), p.link("D3", "C3", crank * (1 + longer));
  p.body("coupler", {"C1", "C2", "C3"});
  p.drive_angle("D1", "C1");
  return {p.release(), {1.0}, 3};
}

}  // namespace

std::span<const Family> overconstrained_families() {
  static const std::array<Family, 4> all{
      Family{"contradicting_cranks",
             [](Random& r) {
               const int sign = r.sign();
               return three_cranks(r, sign * r.log_uniform(1e-16, 1e-5));
             }},
      Family{"three_cranks", [](Random& r) { return three_cranks(r, 0); }},
      spatial_families()[0],  // Bennett's
      spatial_families()[1],  // spherical
  };
  return all;
}

Draft draw_contradicting(Random& r) {
  const Family& family = overconstrained_families().front();
  Draft d = draft_inside(r, family.name, path_of(draw(family, r)));
  d.aim = "contradicting";
  return d;
}

Draft draw_typed(Random& r) {
  static constexpr std::array digits{3, 6, 9, 12, 17};
  const Family& family = overconstrained_families()[1 + r.below(3)];
  Drawn drawn = draw(family, r);
  const int typed = r.pick(digits);
  round_numbers(drawn.mechanism, typed);
  drawn.exact = false;
  Draft d = draft_inside(r, family.name, path_of(std::move(drawn)));
  d.aim = formatted("%d digits", typed);
  return d;
}

}  // namespace desmo::properties
