#include "tests/library/solutions.h"

namespace desmo::exact {

Solution slider_crank(double time) {
  constexpr Real crank = 0.05L, rod = 0.15L;
  const Jet theta = Jet(2 * pi) * Jet::time(time);
  const Vec2 A{{0, 0}}, B = polar(crank, theta);
  const Vec2 C{{B[0] + sqrt(Jet(rod * rod) - B[1] * B[1]), 0}};

  Solution s;
  s.add("A", A);
  s.add("B", B);
  s.add("C", C);
  s.add("x", Vec2{{1, 0}});
  s.add("theta", theta);
  s.add("phi", angle(C - B));
  s.add("s", C[0]);
  return s;
}

Solution inverted_slider_crank(double time) {
  const Jet length = Jet(0.92L) + Jet(0.25L) * sin(Jet(pi) * Jet::time(time));
  const Vec2 O{{0, 0}}, D{{0.5L, 0}}, B0{{0.3L, 0.9L}}, P0{{1.2L, 1.1L}};
  // The cosine rule in the triangle of the two pivots and the head of the rod.
  const Jet OB = norm(B0), OD = norm(D);
  const Jet cosine = (OB * OB + OD * OD - length * length) / (Jet(2) * OB * OD);
  const Jet theta = atan2(sqrt(Jet(1) - cosine * cosine), cosine);
  const Vec2 B = polar(OB, theta), u = unit(B - D);

  Solution s;
  s.add("O", O);
  s.add("D", D);
  s.add("B", B);
  s.add("P", carried(O, B, O, B0, P0));
  s.add("u", u);
  s.add("s", length);
  s.add("theta", theta);
  s.add("psi", angle(u));
  return s;
}

Solution whitworth(double time) {
  constexpr Real offset = 0.02L, crank = 0.05L, arm = 0.035L, link = 0.15L;
  const Jet theta = Jet(pi / 2) + Jet(2 * pi) * Jet::time(time);
  const Vec2 Q{{0, -offset}}, A = polar(crank, theta);
  const Jet r = sqrt(Jet(crank * crank + offset * offset) + Jet(2 * crank * offset) * sin(theta));
  const Vec2 u = (Jet(1) / r) * (A - Q), C = Q - Jet(arm) * u;
  const Jet height = Q[1] - C[1];
  const Vec2 D{{C[0] + sqrt(Jet(link * link) - height * height), Q[1]}};

  Solution s;
  s.add("O", Vec2{{0, 0}});
  s.add("Q", Q);
  s.add("A", A);
  s.add("C", C);
  s.add("D", D);
  s.add("u", u);
  s.add("x", Vec2{{1, 0}});
  s.add("theta", theta);
  s.add("psi", angle(u));
  s.add("r", r);
  s.add("ram_position", D[0]);
  return s;
}

}  // namespace desmo::exact
