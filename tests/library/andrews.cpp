#include "tests/library/solutions.h"

namespace desmo::exact {

/// Dimensions and the seven angles as in Hairer & Wanner, Solving Ordinary Differential Equations
/// II, section VII.7. Given the motor's angle, three triangles follow one after the other.
Solution andrews(double time) {
  constexpr Real d = 0.028L, da = 0.0115L, e = 0.02L, ea = 0.01421L, rr = 0.007L, ra = 0.00092L,
                 ss = 0.035L, sa = 0.01874L, sb = 0.01043L, sc = 0.018L, sd = 0.02L, zt = 0.04L,
                 ta = 0.02308L, tb = 0.00916L, u = 0.04L, ua = 0.01228L, ub = 0.00449L, zf = 0.02L,
                 fa = 0.01421L;
  const Vec2 O{{0, 0}}, A{{-0.06934L, -0.00227L}}, B{{-0.03635L, 0.03273L}}, C{{0.014L, 0.072L}};
  const Vec2 down{{0, -1}};
  const Jet beta = Jet(-0.0617138900142764496L) + Jet(2 * pi) * Jet::time(time);

  const Vec2 F = polar(rr, beta), E = meet(F, d, B, ss, Side::left);
  const Vec2 G = meet(E, e, A, zt, Side::right), H = meet(E, zf, A, u, Side::left);
  // Directions of the links, from which offsets and relative angles are measured.
  const Vec2 k3 = unit(E - B), k5 = unit(G - A), k7 = unit(H - A);
  const Vec2 v5 = Jet(-1) * turned(k5), v7 = turned(k7);
  const Vec2 D = B + Jet(sc) * k3 + Jet(sd) * turned(k3);

  Solution s{{"O", O}, {"A", A}, {"B", B}, {"C", C}, {"F", F},
             {"E", E}, {"G", G}, {"H", H}, {"D", D}};
  s.insert({{"down", down}, {"v5", v5}, {"v7", v7}});
  s.insert({{"S1", polar(ra, beta)},
            {"S2", F + Jet(da / d) * (E - F)},
            {"S3", B + Jet(sa) * k3 + Jet(sb) * turned(k3)},
            {"S4", G + Jet((e - ea) / e) * (E - G)},
            {"S5", A + Jet(ta) * k5 + Jet(tb) * turned(k5)},
            {"S6", H + Jet((zf - fa) / zf) * (E - H)},
            {"S7", A + Jet(ua) * k7 - Jet(ub) * turned(k7)},
            {"beta", beta},
            {"Theta", angle(F - E, F - O)},
            {"gamma", angle(E - B, down)},
            {"Phi", angle(E - G, v5)},
            {"delta", angle(G - A)},
            {"Omega", angle(E - H, v7)},
            {"epsilon", angle(H - A, down)},
            {"spring", norm(C - D)}});
  return s;
}

}  // namespace desmo::exact
