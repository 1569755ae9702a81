#include "report/text/digits.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace desmo::report {
namespace {

std::string characters(double value, std::chars_format format, int decimals) {
  std::array<char, 512> buffer;  // the longest double has 309 digits before the point
  const auto end =
      std::to_chars(buffer.data(), buffer.data() + buffer.size(), value, format, decimals).ptr;
  return {buffer.data(), end};
}

}  // namespace

DigitStyle significant_digits(double value, int significant) {
  if (value == 0) return {false, significant - 1};
  // The exponent is taken after rounding: 9.9996 with four digits is 10.00.
  const std::string rounded = characters(value, std::chars_format::scientific, significant - 1);
  const int exponent = std::stoi(rounded.substr(rounded.find('e') + 1));
  if (exponent < -6 || exponent > 6) return {true, significant - 1};
  return {false, std::max(0, significant - 1 - exponent)};
}

DigitStyle ratio_digits(double value) {
  return value >= 0.1 && value < 100 ? DigitStyle{false, 2} : significant_digits(value, 3);
}

std::optional<double> read_number(std::string_view text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end ? std::optional(value) : std::nullopt;
}

std::string write_order(double value) {
  const double rounded = *read_number(characters(value, std::chars_format::scientific, 0));
  return write(rounded, significant_digits(rounded, 1));
}

std::string write_change(double percent) {
  const std::string digits = write_fixed(percent, 1);
  return (percent > 0 && digits != "0.0" ? "+" : "") + digits;
}

std::string write_shortest(double value) {
  std::array<char, 32> buffer;
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

std::string write(double value, DigitStyle style) {
  const auto format = style.scientific ? std::chars_format::scientific : std::chars_format::fixed;
  std::string result = characters(value, format, style.decimals);
  const bool zero = result.find_first_of("123456789") >= result.find('e');
  if (zero && result.front() == '-') result.erase(0, 1);
  return result;
}

}  // namespace desmo::report
