// Row 7: the same mechanism in other units, and mechanisms of different size in one model.
#include <cmath>
#include <string>
#include <utility>

#include "cases/extremes/rows.h"
#include "cases/mechanism/formatted.h"

namespace desmo::extremes {

namespace {

constexpr TimeGrid scale_grid{0, 0.05, 61};

ExtremeCase as_first(ExtremeCase c) {
  c.bound = Bound::first_case;
  c.factor = 4;
  return c;
}

ExtremeCase scaled(double scale) {
  ExtremeCase c = as_first(
      case_of(formatted("× %.0e", scale), usual_chain(3, chain_start, scale), 1, scale_grid));
  c.may_fail = scale * scale * 1e-16 < 1e-308;  // no proof where roundings of squares underflow
  return c;
}

ExtremeCase both() {
  DyadChain small = usual_chain(3, chain_start, 1e-9), large = usual_chain(3, chain_start, 1e9);
  small.prefix = "small/";
  large.prefix = "large/";
  const Motion turning = Polynomial{{chain_start, 1}};
  return as_first(
      case_of("× 1e-9 and × 1e9 in one", {small, large}, {turning, turning}, scale_grid));
}

/// Makes a four-bar with links of 60 mm at the end of an arm.
/// - arm: its length [m]; rate: its angular velocity [rad/s]
ExtremeCase on_arm(std::string name, double arm, double rate = 1e-7) {
  constexpr double crank = 0.02, link = 0.06, start = 1;
  MechanismBuilder builder("four_bar_on_arm", 2);
  const double bx = arm + crank * std::cos(start), by = crank * std::sin(start);
  const double dx = arm + link - bx, dy = -by, half = std::hypot(dx, dy) / 2;
  const double height = std::sqrt(link * link - half * half) / (2 * half);
  const int o = builder.point("O", {}), a = builder.point("A", {arm}),
            e = builder.point("D", {arm + link}), b = builder.point("B", {bx, by}),
            c = builder.point("C", {bx + dx / 2 - height * dy, by + dy / 2 + height * dx});
  builder.carry(MechanismBuilder::ground, {o});
  const int bodies[] = {builder.body("arm", {o, a, e}), builder.body("crank", {a, b}),
                        builder.body("coupler", {b, c}), builder.body("rocker", {e, c})};
  using enum Mechanism::JointType;
  builder.joint(revolute, MechanismBuilder::ground, bodies[0], {o});
  builder.joint(revolute, bodies[0], bodies[1], {a});
  builder.joint(revolute, bodies[1], bodies[2], {b});
  builder.joint(revolute, bodies[2], bodies[3], {c});
  builder.joint(revolute, bodies[0], bodies[3], {e});
  builder.angle("alpha", {-1, o, a}).driven = true;
  builder.angle("theta", {-1, a, b}).driven = true;
  return {.name = std::move(name),
          .scene = {"four_bar_on_arm",
                    builder.release(),
                    {Polynomial{{0, rate}}, Polynomial{{start, 1}}},
                    scale_grid},
          // Widens the bound: coordinates as large as the arm are rounded coarsely.
          .factor = 1000};
}

}  // namespace

std::vector<ExtremeCase> scales(Extent) {
  return {case_of("× 1", usual_chain(3, chain_start), 1, scale_grid),
          scaled(1e-9),
          scaled(1e9),
          both(),
          scaled(1e-150),
          scaled(1e150),
          on_arm("60 mm on an arm of 10 km", 1e4),
          on_arm("60 mm on an arm of 100 km", 1e5),
          on_arm("60 mm on an arm of 20 m, fast", 20, 0.1)};
}

}  // namespace desmo::extremes
