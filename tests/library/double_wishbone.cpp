#include <array>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

namespace {

/// A frame with one direction given, the second as near to x as that allows.
struct Frame {
  Vec3 i, j, k;
  explicit Frame(const Vec3& along)
      : i(unit(x_axis - (dot(x_axis, unit(along)) * unit(along)))),
        j(cross(unit(along), i)),
        k(unit(along)) {}
};

}  // namespace

/// Unknown: the angles of the two wishbones and that of the upright about the line between its
/// ball joints. They give the upright, the tie rod and the wheel what they ask for.
Solution double_wishbone(double time) {
  const Vec3 LO{{0, 0.350L, 0.200L}}, LB0{{0.010L, 0.720L, 0.190L}}, UO{{-0.010L, 0.420L, 0.480L}},
      UB0{{-0.010L, 0.680L, 0.500L}}, TO0{{-0.130L, 0.700L, 0.300L}}, RK{{-0.120L, 0, 0.290L}},
      W0{{0, 0.760L, 0.330L}}, N0{{0, 0.765L, 0.020L}}, DL0{{0, 0.600L, 0.230L}},
      DC{{-0.010L, 0.450L, 0.650L}};
  const Vec3 lw = unit(Vec3{{1, 0.02L, -0.03L}}), uw = unit(Vec3{{1, -0.03L, 0.05L}}), a0 = y_axis;
  const Jet steering = 0.380L,
            height = Jet(0.330L) + Jet(0.070L) * sin(Jet(2 * pi) * Jet::time(time));
  const Vec3 TI = RK + steering * y_axis, TI0{{-0.120L, 0.380L, 0.290L}};
  const Frame drawn(UB0 - LB0);

  struct Position {
    Vec3 LB, UB;
    Frame upright;
  };
  const auto position = [&](const std::array<Jet, 3>& x) {
    const Vec3 LB = LO + rotated(LB0 - LO, lw, x[0]), UB = UO + rotated(UB0 - UO, uw, x[1]);
    Frame upright(UB - LB);
    upright.i = rotated(upright.i, upright.k, x[2]);
    upright.j = cross(upright.k, upright.i);
    return Position{LB, UB, upright};
  };
  const auto turned = [&](const Frame& f, const Vec3& v) {
    return dot(drawn.i, v) * f.i + dot(drawn.j, v) * f.j + dot(drawn.k, v) * f.k;
  };
  const std::array<Jet, 3> x = solve<3>({0, 0, 0}, [&](const std::array<Jet, 3>& guess) {
    const Position p = position(guess);
    const Vec3 kingpin = p.UB - p.LB, tie_rod = p.LB + turned(p.upright, TO0 - LB0) - TI;
    return std::array{dot(kingpin, kingpin) - dot(UB0 - LB0, UB0 - LB0),
                      dot(tie_rod, tie_rod) - dot(TO0 - TI0, TO0 - TI0),
                      p.LB[2] + turned(p.upright, W0 - LB0)[2] - height};
  });
  const Position p = position(x);
  const auto on_upright = [&](const Vec3& at) { return p.LB + turned(p.upright, at - LB0); };
  const Vec3 a = turned(p.upright, a0), DL = LO + rotated(DL0 - LO, lw, x[0]);

  Solution s{{"LO", LO}, {"UO", UO}, {"RK", RK}, {"DC", DC}, {"TI", TI}, {"DL", DL}};
  s.insert({{"x", x_axis},
            {"y", y_axis},
            {"z", z_axis},
            {"lw", lw},
            {"uw", uw},
            {"a", a},
            {"steering", steering},
            {"height", height}});
  s.insert({{"LB", p.LB},
            {"UB", p.UB},
            {"TO", on_upright(TO0)},
            {"W", on_upright(W0)},
            {"N", on_upright(N0)},
            {"toe", atan2(a[0], a[1])},
            {"camber", atan2(a[2], a[1])},
            {"damper", norm(DC - DL)}});
  return s;
}

}  // namespace desmo::exact
