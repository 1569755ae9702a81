// Closed forms of linkages without couplings: bodies by tables of their points, and joints in space
// that hold points on lines and planes.

#include "tests/load/closed_forms.h"

namespace desmo::load::closed_forms {

/// Nothing is coupled, nor drawn: bodies have frames, whose places are 14 % of its size off.
Values excavator(double t) {
  const auto cylinder = [&](Real mean, Real amplitude, Real frequency) {
    return Jet(mean) + Jet(amplitude) * sin(Jet(2 * pi * frequency) * Jet::time(t));
  };
  const Vec2 O{{0, 0}}, G{{Jet(0.45L), Jet(-0.35L)}};
  const Vec2 b{{Jet(1.9L), Jet(0.75L)}}, d{{Jet(2.2L), Jet(1.05L)}}, s{{Jet(3.8L), Jet(0.1L)}};
  const Vec2 B = meet(G, cylinder(2.15L, 0.1L, 0.5L), O, norm(b), Side::right);
  const Vec2 D = carried(O, B, O, b, d), S = carried(O, B, O, b, s);
  const Vec2 e{{Jet(-0.55L), Jet(0.15L)}}, k{{Jet(0.1L), Jet(0.45L)}}, h{{Jet(1.55L), 0}};
  const Vec2 E = meet(D, cylinder(1.95L, 0.2L, 0.5L), S, norm(e), Side::left);
  const Vec2 K = carried(S, E, O, e, k), H = carried(S, E, O, e, h),
             T = carried(S, E, O, e, {{Jet(1.85L), 0}});
  const Vec2 J = meet(K, cylinder(1.45L, 0.15L, 1), H, Jet(0.42L), Side::left);
  const Vec2 n{{Jet(0.05L), Jet(0.32L)}};
  const Vec2 N = meet(J, Jet(0.4L), T, norm(n), Side::left);
  Values v;
  add(v, "D", D), add(v, "S", S), add(v, "K", K), add(v, "J", J), add(v, "N", N);
  add(v, "u", unit(B - G)), add(v, "v", unit(E - D));
  add(v, "tip", carried(T, N, O, n, {{1, Jet(-0.1L)}}));
  return v;
}

/// A crank on a tilted hinge leads a lever in space by a pin in its slot, and carries a plane on
/// which a puck lies. Q of the puck keeps to an upright line, R to an upright plane.
Values guides(double t) {
  const Jet seventh(1.0L / 7);
  const Vec3 u = seventh * Vec3{{6, 2, -3}}, v = seventh * Vec3{{-3, 6, -2}},
             w = seventh * Vec3{{2, 3, 6}};
  const Jet theta = degrees(t, 0, 200, 60), reach(0.7L);
  const Vec3 H = reach * w, B = reach * (cos(theta) * u + sin(theta) * v + w);
  const Vec3 way{{B[0] + Jet(2), B[1] - Jet(0.5L), 0}};
  const Vec3 slope = (Jet(1) / norm(way)) * way + Vec3{{0, 0, Jet(0.25L)}};
  const Vec3 D{{-2, Jet(0.5L), B[2] - Jet(0.25L) * norm(way)}};
  const Vec3 n0 = unit(Vec3{{1, 2, 6}}), n = rotated(n0, w, theta);
  const Vec3 Q0{{Jet(0.4L), 1, Jet(0.9L)}}, R0{{1, Jet(1.2L), Jet(0.5L)}};
  const Vec3 M{{Q0[0], Q0[1], 0}};
  const Vec3 Q = M + ((dot(n0, Q0 - H) - dot(n, M - H)) / n[2]) * z_axis;
  const Jet up = dot(n0, R0 - Q0), along = norm(R0 - Q0 - up * n0);
  const Vec3 level = unit(cross(y_axis, n)), rise = cross(n, level);
  const Jet sine = (R0[1] - Q[1] - up * n[1]) / (along * rise[1]);
  Values values{{"psi", angle(Vec2{{way[0], way[1]}})}, {"lift", D[2]}};
  add(values, "B", B), add(values, "D", D), add(values, "s", unit(slope));
  add(values, "Q", Q), add(values, "n", n);
  add(values, "R", Q + up * n + along * (sqrt(Jet(1) - sine * sine) * level + sine * rise));
  return values;
}

}  // namespace desmo::load::closed_forms
