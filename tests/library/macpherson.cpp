#include <array>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

/// Unknown: the angle of the arm and the turn of the upright. The line of the strut passes through
/// its mount, the tie rod keeps its length, the wheel has its height.
Solution macpherson(double time) {
  const Vec3 LO{{0, 0.380L, 0.190L}}, LB0{{0.005L, 0.730L, 0.180L}}, U0{{-0.010L, 0.640L, 0.450L}},
      T{{-0.030L, 0.570L, 0.830L}}, TO0{{-0.140L, 0.690L, 0.280L}}, RK{{-0.130L, 0, 0.270L}},
      TI0{{-0.130L, 0.360L, 0.270L}}, W0{{0, 0.770L, 0.310L}}, N0{{0, 0.775L, 0}};
  const Vec3 lw = unit(Vec3{{1, 0.03L, 0.02L}}), d0 = unit(T - U0), a0 = y_axis;
  const Vec3 across1 = unit(cross(d0, x_axis)), across2 = cross(d0, across1);
  const Jet t = Jet::time(time);
  const Jet steering = Jet(0.360L) + Jet(0.030L) * sin(Jet(pi) * t);
  const Jet height =
      Jet(0.310L) + Jet(0.060L) * sin(Jet(2 * pi) * t) + Jet(0.010L) * sin(Jet(6 * pi) * t);
  const Vec3 TI = RK + steering * y_axis;

  const auto upright_at = [&](const std::array<Jet, 4>& x) {
    return Body{LB0, LO + rotated(LB0 - LO, lw, x[0]), {{x[1], x[2], x[3]}}};
  };
  const Body upright = upright_at(solve<4>({0, 0, 0, 0}, [&](const std::array<Jet, 4>& x) {
    const Body guess = upright_at(x);
    const Vec3 strut = T - guess.point(U0), tie_rod = guess.point(TO0) - TI;
    return std::array{dot(strut, guess.direction(across1)), dot(strut, guess.direction(across2)),
                      dot(tie_rod, tie_rod) - dot(TO0 - TI0, TO0 - TI0),
                      guess.point(W0)[2] - height};
  }));
  const Vec3 U = upright.point(U0), d = unit(T - U), a = upright.direction(a0);

  Solution s{{"LO", LO}, {"RK", RK}, {"T", T}, {"U", U}, {"TI", TI}};
  s.insert({{"x", x_axis},
            {"y", y_axis},
            {"z", z_axis},
            {"lw", lw},
            {"d", d},
            {"a", a},
            {"steering", steering},
            {"height", height}});
  s.insert({{"LB", upright.at},
            {"TO", upright.point(TO0)},
            {"W", upright.point(W0)},
            {"N", upright.point(N0)},
            {"e", unit(cross(d, x_axis))},
            {"strut", norm(T - U)},
            {"toe", atan2(a[0], a[1])},
            {"camber", atan2(a[2], a[1])}});
  return s;
}

}  // namespace desmo::exact
