#include <array>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

/// Unknown: the angle of the lower wishbone and the turn of the upright. The upper ball joint keeps
/// to its circle about the hinge, the tie rod keeps its length, the wheel has its height.
Solution double_wishbone(double time) {
  const Vec3 LO{{0, 0.350L, 0.200L}}, LB0{{0.010L, 0.720L, 0.190L}}, UO{{-0.010L, 0.420L, 0.480L}},
      UB0{{-0.010L, 0.680L, 0.500L}}, TO0{{-0.130L, 0.700L, 0.300L}}, RK{{-0.120L, 0, 0.290L}},
      W0{{0, 0.760L, 0.330L}}, N0{{0, 0.765L, 0.020L}}, DL0{{0, 0.600L, 0.230L}},
      DC{{-0.010L, 0.450L, 0.650L}};
  const Vec3 lw = unit(Vec3{{1, 0.02L, -0.03L}}), uw = unit(Vec3{{1, -0.03L, 0.05L}}), a0 = y_axis;
  const Jet steering = 0.380L,
            height = Jet(0.330L) + Jet(0.070L) * sin(Jet(2 * pi) * Jet::time(time));
  const Vec3 TI = RK + steering * y_axis, TI0{{-0.120L, 0.380L, 0.290L}};

  const auto upright_at = [&](const std::array<Jet, 4>& x) {
    return Body{LB0, LO + rotated(LB0 - LO, lw, x[0]), {{x[1], x[2], x[3]}}};
  };
  const std::array<Jet, 4> x = solve<4>({0, 0, 0, 0}, [&](const std::array<Jet, 4>& guess) {
    const Body upright = upright_at(guess);
    const Vec3 upper = upright.point(UB0) - UO, tie_rod = upright.point(TO0) - TI;
    return std::array{dot(upper, upper) - dot(UB0 - UO, UB0 - UO), dot(uw, upper - (UB0 - UO)),
                      dot(tie_rod, tie_rod) - dot(TO0 - TI0, TO0 - TI0),
                      upright.point(W0)[2] - height};
  });
  const Body upright = upright_at(x);
  const Vec3 a = upright.direction(a0), DL = LO + rotated(DL0 - LO, lw, x[0]);

  Solution s{{"LO", LO}, {"UO", UO}, {"RK", RK}, {"DC", DC}, {"TI", TI}, {"DL", DL}};
  s.insert({{"x", x_axis},
            {"y", y_axis},
            {"z", z_axis},
            {"lw", lw},
            {"uw", uw},
            {"a", a},
            {"steering", steering},
            {"height", height}});
  s.insert({{"LB", upright.at},
            {"UB", upright.point(UB0)},
            {"TO", upright.point(TO0)},
            {"W", upright.point(W0)},
            {"N", upright.point(N0)},
            {"toe", atan2(a[0], a[1])},
            {"camber", atan2(a[2], a[1])},
            {"damper", norm(DC - DL)}});
  return s;
}

}  // namespace desmo::exact
