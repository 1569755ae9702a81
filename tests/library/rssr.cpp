#include "tests/library/solutions.h"

namespace desmo::exact {

Solution rssr(double time) {
  constexpr Real crank = 0.3L, rocker = 0.8L;
  const Vec3 O{{0, 0, 0}}, C{{0.8L, 0.6L, 0.3L}}, a{{crank, 0, 0}}, b{{0.288L, 1.08L, 0.684L}};
  const Vec3 w{{0.6L, 0, 0.8L}}, v{{-0.8L, 0, 0.6L}};  // the rocker turns from y towards v
  const Jet theta = Jet(2 * pi) * Jet::time(time);
  const Vec3 A{{Jet(crank) * cos(theta), Jet(crank) * sin(theta), 0}};

  // ‖C + r (cos ψ y + sin ψ v) − A‖² = L²
  const Vec3 g = C - A;
  const Jet psi = angle_with(Jet(2 * rocker) * g[1], Jet(2 * rocker) * dot(g, v),
                             dot(b - a, b - a) - dot(g, g) - Jet(rocker * rocker));
  const Vec3 B = C + Jet(rocker) * (cos(psi) * y_axis + sin(psi) * v);

  return {{"O", O},      {"C", C}, {"A", A}, {"B", B},         {"x", x_axis}, {"y", y_axis},
          {"z", z_axis}, {"w", w}, {"v", v}, {"theta", theta}, {"psi", psi}};
}

}  // namespace desmo::exact
