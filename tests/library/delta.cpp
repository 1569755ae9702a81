#include <string>

#include "tests/library/solutions.h"

namespace desmo::exact {

namespace {

/// The lower of the two points at a distance from three others.
Vec3 below(const Vec3 (&c)[3], Jet distance) {
  const Vec3 u = c[1] - c[0], v = c[2] - c[0], n = cross(u, v);
  // The centre of the circle through the three, from the first.
  const Vec3 m = (Jet(1) / (Jet(2) * dot(n, n))) * cross(dot(u, u) * v - dot(v, v) * u, n);
  const Jet height = sqrt((distance * distance - dot(m, m)) / dot(n, n));
  return c[0] + m - (n[2].v > 0 ? height : -height) * n;
}

}  // namespace

/// Parallelograms keep the platform from turning: its centre lies on three spheres.
Solution delta(double time) {
  constexpr Real base = 0.2L, arm = 0.3L, rod = 0.8L, platform = 0.06L, half_width = 0.05L;
  const Vec3 down{{0, 0, -1}};
  const Jet t = Jet::time(time);
  Jet phi[3];
  Vec3 r[3], w[3], E[3], centre[3];
  for (int i = 0; i < 3; ++i) {
    phi[i] = Jet(0.5L) + Jet(0.35L) * sin(Jet(2 * pi) * t + Jet(2 * i));
    r[i] = {{std::cos(2 * pi / 3 * i), std::sin(2 * pi / 3 * i), 0}};
    w[i] = cross(z_axis, r[i]);
    E[i] = (Jet(base) + Jet(arm) * cos(phi[i])) * r[i] + Jet(arm) * sin(phi[i]) * down;
    centre[i] = E[i] - Jet(platform) * r[i];
  }
  const Vec3 P = below(centre, rod);

  Solution s{{"P", P}, {"down", down}, {"px", x_axis}, {"py", y_axis}, {"pz", z_axis}};
  for (int i = 0; i < 3; ++i) {
    const std::string n = std::to_string(i + 1);
    const Vec3 F = P + Jet(platform) * r[i], side = Jet(half_width) * w[i];
    s.insert({{"r" + n, r[i]},
              {"w" + n, w[i]},
              {"O" + n, Jet(base) * r[i]},
              {"E" + n, E[i]},
              {"E" + n + "a", E[i] + side},
              {"E" + n + "b", E[i] - side},
              {"F" + n + "a", F + side},
              {"F" + n + "b", F - side},
              {"phi" + n, phi[i]}});
  }
  s.insert({{"Px", P[0]}, {"Py", P[1]}, {"Pz", P[2]}});
  return s;
}

}  // namespace desmo::exact
