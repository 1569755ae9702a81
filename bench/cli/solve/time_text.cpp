#include "bench/cli/solve/time_text.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <optional>

namespace desmo::cli {
namespace {

/// digits · 10^exponent, the shortest decimal that reads back as a double.
struct Decimal {
  std::int64_t digits;
  int exponent;

  explicit Decimal(double value) : digits(0), exponent(0) {
    char text[32];
    const char* const end =
        std::to_chars(text, text + sizeof text, std::abs(value), std::chars_format::scientific).ptr;
    const char* const e = std::find(static_cast<const char*>(text), end, 'e');
    std::from_chars(e[1] == '+' ? e + 2 : e + 1, end, exponent);
    for (const char* c = text; c != e; ++c) {
      if (*c == '.') continue;
      digits = 10 * digits + (*c - '0');
      if (c != text) --exponent;  // digits behind the point
    }
    if (value < 0) digits = -digits;
  }
};

std::int64_t power_of_ten(int exponent) {
  std::int64_t power = 1;
  for (int i = 0; i < exponent; ++i) power *= 10;
  return power;
}

/// Returns start + count · step in decimal arithmetic, rounded to a double; none where it has more
/// digits than 64 bits.
std::optional<double> decimal_time(double start, double step, std::int64_t count) {
  const Decimal a(start), b(step);
  const int exponent = start == 0 ? b.exponent : std::min(a.exponent, b.exponent);
  const int of_a = a.exponent - exponent, of_b = b.exponent - exponent;
  constexpr int max_power = std::numeric_limits<std::int64_t>::digits10;
  if ((start != 0 && of_a > max_power) || of_b > max_power) return std::nullopt;
  std::int64_t first = 0, rest = 0, sum = 0;
  if ((start != 0 && __builtin_mul_overflow(a.digits, power_of_ten(of_a), &first)) ||
      __builtin_mul_overflow(b.digits, power_of_ten(of_b), &rest) ||
      __builtin_mul_overflow(rest, count, &rest) || __builtin_add_overflow(first, rest, &sum))
    return std::nullopt;
  const std::string text = std::to_string(sum) + "e" + std::to_string(exponent);
  double time = 0;
  std::from_chars(text.data(), text.data() + text.size(), time);
  return time;
}

}  // namespace

void append_number(double value, std::string& text) {
  char digits[32];
  const double unsigned_zero = value + 0.0;  // −0 + 0 = 0
  const auto end = std::to_chars(digits, digits + sizeof digits, unsigned_zero).ptr;
  text.append(digits, end);
}

void append_time(double time, const TimeGrid& grid, std::string& text) {
  const double index = std::round((time - grid.start) / grid.interval());
  const bool is_instant =
      index >= 0 && index < grid.instants && grid.time(static_cast<int>(index)) == time;
  const auto decimal =
      is_instant ? decimal_time(grid.start, grid.step,
                                static_cast<std::int64_t>(index) * grid.steps_per_interval)
                 : std::nullopt;
  append_number(decimal.value_or(time), text);
}

}  // namespace desmo::cli
