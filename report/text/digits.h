// Rounding of numbers to the digits that are shown. It is done once; every format prints these
// characters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace desmo::report {

/// The form of a number. It is chosen for one value and used for its spread, too.
struct DigitStyle {
  bool scientific = false;  ///< it has an exponent
  int decimals = 0;         ///< number of digits after the point
};

/// Returns the form in which `value` shows `significant` digits: 7.100, 0.6070, 0.0008123. It is
/// scientific for a rounded magnitude of 1e7 or more, and for one below 1e-6 that is not 0.
DigitStyle significant_digits(double value, int significant);

/// Returns the form of a speed-up: two decimals where 0.1 ≤ value < 100, else three significant
/// digits.
DigitStyle ratio_digits(double value);

/// Writes a value with one significant digit, its order of magnitude: 30, 0.8, 0.004.
std::string write_order(double value);

/// Writes a finite value as a JSON number, whatever the locale. What rounds to 0 has no minus sign.
std::string write(double value, DigitStyle style);

/// Writes the fewest digits that tell the value from every other double: 0.01, 1e-10.
std::string write_shortest(double value);

/// Reads a whole text as a number; returns nothing when it is none.
std::optional<double> read_number(std::string_view text);

/// Writes a change [%] to the tenth with its sign; a change that rounds to 0.0 has none.
std::string write_change(double percent);

/// Returns digits as JSON writes them: without a plus sign.
inline std::string_view without_plus(std::string_view digits) {
  return digits.substr(digits.starts_with('+') ? 1 : 0);
}

inline std::string write_fixed(double value, int decimals) {
  return write(value, {false, decimals});
}
inline std::string write_significant(double value, int significant) {
  return write(value, significant_digits(value, significant));
}

}  // namespace desmo::report
