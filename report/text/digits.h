// Rounding to what is shown, once: every format prints these characters.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace desmo::report {

/// The form of a number: chosen for one value and kept for what stands next to it (its spread).
struct DigitStyle {
  bool scientific = false;
  int decimals = 0;
};

/// Returns the form in which `value` shows `significant` digits: 7.100, 0.6070, 0.0008123;
/// scientific outside 1e-6 ... 1e7.
DigitStyle significant_digits(double value, int significant);

/// Speed-ups: two decimals between 0.1 and 100, three significant digits elsewhere.
DigitStyle ratio_digits(double value);

/// Returns a value's order of magnitude, one significant digit: 30, 0.8, 0.004.
std::string write_order(double value);

/// Locale-independent decimal digits, valid as a JSON number; never "-0". The value is finite.
std::string write(double value, DigitStyle style);

/// Returns the fewest digits that tell the value from every other: for settings, 0.01 and 1e-10.
std::string write_shortest(double value);

/// Returns the number that a text is, all of it; nothing when it is none.
std::optional<double> read_number(std::string_view text);

/// Returns a change [%] to the tenth with its sign; rounded to nothing, it has none.
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
