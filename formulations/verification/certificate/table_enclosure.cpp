#include "formulations/verification/certificate/table_enclosure.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "formulations/constraints/table.h"

namespace desmo {

namespace {

/// Maximum number of knots on one side within the distance (≤); with more, radii are infinite.
/// Steps of a motion pass fewer.
constexpr int max_knots = 16;

/// Raises radii k to at least |f⁽ᵏ⁾|/k! within a distance of 0, where f is the difference of two
/// polynomials.
void add_difference(const std::array<Derived, 4>& a, const std::array<Derived, 4>& b,
                    double distance, std::array<double, 4>& radii) {
  constexpr int binomial[4][4] = {{1, 1, 1, 1}, {0, 1, 2, 3}, {0, 0, 1, 3}, {0, 0, 0, 1}};
  for (int k = 0; k < 4; ++k) {
    double sum = 0;
    for (int l = 3; l >= k; --l) {
      const Derived d = a[l] - b[l];
      sum = sum * distance + binomial[k][l] * (std::abs(d.value) + rest_of(d));
    }
    radii[k] = std::max(radii[k], sum * (1 + 0x1p-40));
  }
}

}  // namespace

std::array<Derived, 4> TablePieces::about(int piece, double turns, double at) const {
  const Derived t = -distance(piece, turns, at);
  const auto c = [&](int k) { return number(4 + count + 4 * piece + k); };
  const Derived c1 = c(1), c2 = c(2), c3 = c(3);
  return {((c3 * t + c2) * t + c1) * t + c(0) + number(2) * turns, (c3 * 3 * t + c2 * 2) * t + c1,
          c3 * 3 * t + c2, c3};
}

std::array<Derived, 4> enclose_table(const TableNumbers& number, double at, double distance) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  std::array<Derived, 4> result;
  const auto [piece, turns] = find_in_table<double>([&](int k) { return number(k).value; }, at);
  if (piece < 0) {
    result.fill(Derived(none, {0, INFINITY}));
    return result;
  }
  const TablePieces table{number};
  const std::array<Derived, 4> own = table.about(piece, turns, at);
  const double reach = distance * (1 + 0x1p-40);
  std::array<double, 4> radii{};
  bool is_bounded = std::isfinite(reach);
  for (const int way : {-1, 1}) {
    int p = piece;
    double t = turns;
    for (int knots = 0; is_bounded; ++knots) {
      const bool is_last = way < 0 ? p == 0 : p == table.count - 1;
      const Derived far = table.distance(way < 0 ? p : p + 1, t, at);
      const double to_knot = way * far.value - rest_of(far);
      if (to_knot > reach) break;
      if (is_last && !table.repeats) {
        is_bounded = reach <= to_knot + table_margin * table.length.value;
        break;
      }
      is_bounded = knots < max_knots;
      p += way;
      if (is_last) p = way < 0 ? table.count - 1 : 0, t += way;
      add_difference(table.about(p, t, at), own, reach, radii);
    }
  }
  for (int k = 0; k < 4; ++k) {
    result[k] = own[k];
    result[k].radius += is_bounded ? radii[k] : INFINITY;
  }
  return result;
}

}  // namespace desmo
