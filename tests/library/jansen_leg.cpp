#include "tests/library/solutions.h"

namespace desmo::exact {

Solution jansen_leg(double time) {
  // Theo Jansen's "holy numbers".
  constexpr Real a = 38, b = 41.5L, c = 39.3L, d = 40.1L, e = 55.8L, f = 39.4L, g = 36.7L,
                 h = 65.7L, i = 49, j = 50, k = 61.9L, l = 7.8L, m = 15;
  const Jet theta = Jet(-2 * pi) * Jet::time(time);
  const Vec2 O{{0, 0}}, Q{{-a, -l}}, K = polar(m, theta);
  const Vec2 T = meet(Q, b, K, j, Side::left), L = meet(Q, c, K, k, Side::right);
  const Vec2 W = meet(Q, d, T, e, Side::left), R = meet(L, g, W, f, Side::left);
  const Vec2 F = meet(L, i, R, h, Side::left);

  Solution s{{"O", O}, {"Q", Q}, {"K", K}, {"T", T}, {"W", W}, {"L", L}, {"R", R}, {"F", F}};
  s.insert({{"theta", theta}, {"phi", angle(T - Q)}, {"psi", angle(F - L)}, {"step_height", F[1]}});
  return s;
}

}  // namespace desmo::exact
