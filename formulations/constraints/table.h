#pragma once

#include <cmath>
#include <limits>

// A table of a coupling as numbers t[]: {n, repeats, advance, knots (n + 1), pieces (4 n)}, where
// piece i is {c₀ … c₃} of c₀ + c₁ τ + c₂ τ² + c₃ τ³ with τ since knot i. With `repeats` not 0 it
// continues on both sides, higher by `advance` after each of its lengths. Generated code contains
// this text.

namespace desmo {

/// Returns how many numbers a table of n pieces has.
constexpr int table_size(int n) { return 5 * n + 4; }

/// Maximum distance (≤) of an argument outside of a table that does not repeat, relative to the
/// table's length. The outer pieces are continued over this distance. Rounding of times and units
/// causes a smaller one.
inline constexpr double table_margin = 1e-9;

/// Place of an argument in a table. piece: -1: outside.
struct TablePlace {
  int piece;
  double turns;  ///< number of whole lengths of the table taken off the argument
};

/// Finds the place of an argument x. number(k): number k of the table, in a scalar that has
/// comparisons.
template <class S, class Number>
TablePlace find_in_table(const Number& number, const S& x) {
  const int n = static_cast<int>(number(0));
  const S first = number(3), last = number(3 + n), length = last - first;
  double turns = 0;
  S at = x;
  if (number(1) != 0) {
    turns = std::floor(static_cast<double>((x - first) / length));
    at = x - S(turns) * length;
    if (at < first) at = at + length, turns -= 1;  // rounding may leave it outside
    if (!(at < last)) at = at - length, turns += 1;
  }
  const S margin = S(table_margin) * length;
  if (!(at >= first - margin && at <= last + margin)) return {-1, turns};
  int low = 0;
  for (int high = n; high - low > 1;) {
    const int middle = (low + high) / 2;
    (number(3 + middle) <= at ? low : high) = middle;
  }
  return {low, turns};
}

/// Returns Taylor's coefficient f⁽ᵏ⁾(x)/k! of a table f; NaN outside of it.
template <int k, class S, class Number>
S table_number(const Number& number, const S& x) {
  const auto [piece, turns] = find_in_table(number, x);
  if (piece < 0) return S(std::numeric_limits<double>::quiet_NaN());
  const int n = static_cast<int>(number(0)), first = 4 + n + 4 * piece;
  const S length = number(3 + n) - number(3);
  const S since_knot = x - S(turns) * length - number(3 + piece);
  S sum = number(first + 3);
  if constexpr (k == 0)
    for (int i = 3; i-- > 0;) sum = sum * since_knot + number(first + i);
  if constexpr (k == 1)
    sum = (S(3) * sum * since_knot + S(2) * number(first + 2)) * since_knot + number(first + 1);
  if constexpr (k == 2) sum = S(3) * sum * since_knot + number(first + 2);
  return k == 0 ? sum + S(turns) * number(2) : sum;
}

/// Returns the same as table_number(), of a table t[]. T: a floating-point number, or lanes of
/// them.
template <int k, class T>
T table_coefficient(const T* t, const T& x) {
  if constexpr (requires { T::size(); }) {
    T result;
    for (int lane = 0; lane < static_cast<int>(T::size()); ++lane)
      result[lane] = table_number<k>([&](int i) { return static_cast<double>(t[i][lane]); },
                                     static_cast<double>(x[lane]));
    return result;
  } else {
    return table_number<k>([&](int i) { return t[i]; }, x);
  }
}

}  // namespace desmo
