#include <array>
#include <string>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

namespace {

Vec3 on_circle(Real radius, Real degrees, Real height) {
  const Real angle = degrees * pi / 180;
  return {{radius * std::cos(angle), radius * std::sin(angle), height}};
}

}  // namespace

/// The lengths of the legs are known functions of the platform's pose.
Solution stewart(double time) {
  constexpr Real base[] = {-12, 12, 108, 132, 228, 252}, top[] = {-48, 48, 72, 168, 192, 288};
  Vec3 A[6], b[6], g[6];
  Jet length[6];
  const Jet t = Jet::time(time);
  for (int i = 0; i < 6; ++i) {
    A[i] = on_circle(1, base[i], 0);
    b[i] = on_circle(0.6L, top[i], 0);  // on the platform
    g[i] = cross(z_axis, A[i]);
    const int q = i + 1;
    length[i] = Jet(1.35L) + Jet(0.12L) * sin(Jet(pi) * t + Jet(q)) +
                Jet(0.03L) * sin(Jet(2 * pi) * t + Jet(q * q));
  }

  const Body platform = body_at(solve<6>({0, 0, 1.2L, 0, 0, 0}, [&](const std::array<Jet, 6>& x) {
    std::array<Jet, 6> residual;
    for (int i = 0; i < 6; ++i) {
      const Vec3 leg = body_at(x).point(b[i]) - A[i];
      residual[i] = dot(leg, leg) - length[i] * length[i];
    }
    return residual;
  }));

  const Vec3 px = platform.direction(x_axis), pz = platform.direction(z_axis);
  Solution s{{"P", platform.at}, {"x", x_axis}, {"y", y_axis},
             {"z", z_axis},      {"px", px},    {"py", platform.direction(y_axis)},
             {"pz", pz}};
  for (int i = 0; i < 6; ++i) {
    const std::string n = std::to_string(i + 1);
    const Vec3 B = platform.point(b[i]), d = unit(B - A[i]);
    s.insert({{"A" + n, A[i]},
              {"B" + n, B},
              {"g" + n, g[i]},
              {"d" + n, d},
              {"u" + n, unit(cross(g[i], d))},
              {"s" + n, length[i]}});
  }
  s.insert(
      {{"heave", platform.at[2]}, {"yaw", atan2(px[1], px[0])}, {"tilt", atan2(pz[0], pz[2])}});
  return s;
}

}  // namespace desmo::exact
