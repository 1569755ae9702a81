#include "tests/library/solutions.h"

namespace desmo::exact {

Solution slider_crank(double time) {
  constexpr Real crank = 0.05L, rod = 0.15L;
  const Jet theta = Jet(2 * pi) * Jet::time(time);
  const Vec2 A{{0, 0}}, B = polar(crank, theta);
  const Vec2 C{{B[0] + sqrt(Jet(rod * rod) - B[1] * B[1]), 0}};

  return {
      {"A", A},   {"B", B}, {"C", C}, {"x", Vec2{{1, 0}}}, {"theta", theta}, {"phi", angle(C - B)},
      {"s", C[0]}};
}

Solution inverted_slider_crank(double time) {
  const Jet length = Jet(0.92L) + Jet(0.25L) * sin(Jet(pi) * Jet::time(time));
  const Vec2 O{{0, 0}}, D{{0.5L, 0}}, B0{{0.3L, 0.9L}}, P0{{1.2L, 1.1L}};
  // The cosine rule in the triangle of the two pivots and the head of the rod.
  const Jet OB = norm(B0), OD = norm(D);
  const Jet cosine = (OB * OB + OD * OD - length * length) / (Jet(2) * OB * OD);
  const Jet theta = atan2(sqrt(Jet(1) - cosine * cosine), cosine);
  const Vec2 B = polar(OB, theta), u = unit(B - D);

  return {{"O", O}, {"D", D},      {"B", B},         {"P", carried(O, B, O, B0, P0)},
          {"u", u}, {"s", length}, {"theta", theta}, {"psi", angle(u)}};
}

Solution whitworth(double time) {
  constexpr Real offset = 0.02L, crank = 0.05L, arm = 0.035L, link = 0.15L;
  const Jet theta = Jet(pi / 2) + Jet(2 * pi) * Jet::time(time);
  const Vec2 Q{{0, -offset}}, A = polar(crank, theta);
  const Jet r = sqrt(Jet(crank * crank + offset * offset) + Jet(2 * crank * offset) * sin(theta));
  const Vec2 u = (Jet(1) / r) * (A - Q), C = Q - Jet(arm) * u;
  const Jet height = Q[1] - C[1];
  const Vec2 D{{C[0] + sqrt(Jet(link * link) - height * height), Q[1]}};

  return {{"O", Vec2{{0, 0}}},
          {"Q", Q},
          {"A", A},
          {"C", C},
          {"D", D},
          {"u", u},
          {"x", Vec2{{1, 0}}},
          {"theta", theta},
          {"psi", angle(u)},
          {"r", r},
          {"ram_position", D[0]}};
}

}  // namespace desmo::exact
