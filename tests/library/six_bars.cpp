#include <array>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

Solution watt_six_bar(double time) {
  // The drawing that gives the dimensions.
  const Vec2 A0{{0, 0}}, B0{{4, 0}}, a{{0.6L, 0.8L}}, b{{3.6L, 2.8L}}, c{{2.5L, 4.5L}}, d{{6, 3}},
      e{{5.5L, 6}}, p{{7, 7}};
  const Jet theta = Jet(5 * pi / 18) + Jet(2 * pi) * Jet::time(time);
  const Vec2 A = polar(1, theta);
  const Vec2 B = meet(A, norm(b - a), B0, norm(b - B0), Side::left);
  const Vec2 C = carried(A, B, a, b, c), D = carried(B0, B, B0, b, d);
  const Vec2 E = meet(C, norm(e - c), D, norm(e - d), Side::left);

  return {{"A0", A0},
          {"B0", B0},
          {"A", A},
          {"B", B},
          {"C", C},
          {"D", D},
          {"E", E},
          {"P", carried(D, E, d, e, p)},
          {"theta", theta},
          {"psi", angle(B - B0)},
          {"phi", angle(E - D)},
          {"mu", angle(C - E, D - E)}};
}

Solution stephenson_six_bar(double time) {
  const Vec2 A0{{0, 0}}, B0{{5, 0}}, D0{{7, 5}}, a{{-0.5L, 2.5L}}, b{{4, 3.5L}}, c{{2, 5}},
      d{{6.4L, 4.2L}};
  const Jet start = angle(d - D0), theta = start + Jet(2 * pi) * Jet::time(time);
  const Vec2 D = D0 + polar(1, theta);

  // Three links hang on the crank together: with the angle of one of them guessed, the others
  // follow from a four-bar, and the link to the crank has its length for the right guess.
  struct FourBar {
    Vec2 A, B, C;
  };
  const auto four_bar = [&](Jet alpha) {
    const Vec2 A = polar(norm(a), alpha), B = meet(A, norm(b - a), B0, norm(b - B0), Side::left);
    return FourBar{A, B, carried(A, B, a, b, c)};
  };
  const Jet alpha = solve<1>({angle(a).v}, [&](const std::array<Jet, 1>& x) {
    const Vec2 w = four_bar(x[0]).C - D;
    return std::array{dot(w, w) - dot(c - d, c - d)};
  })[0];
  const auto [A, B, C] = four_bar(alpha);

  return {{"A0", A0}, {"B0", B0}, {"D0", D0},       {"A", A},         {"B", B},
          {"C", C},   {"D", D},   {"theta", theta}, {"alpha", alpha}, {"psi", angle(B - B0)}};
}

}  // namespace desmo::exact
