#pragma once

#include <charconv>
#include <cstdarg>
#include <cstdio>
#include <string>
#include <string_view>
#include <system_error>

namespace desmo {

/// Returns the text that printf() would print.
[[gnu::format(printf, 1, 2)]] inline std::string formatted(const char* format, ...) {
  std::va_list values, again;
  va_start(values, format);
  va_copy(again, values);
  std::string text(std::vsnprintf(nullptr, 0, format, again), '\0');
  std::vsnprintf(text.data(), text.size() + 1, format, values);
  va_end(again);
  va_end(values);
  return text;
}

/// Reads the whole of a text as a number (std::from_chars, which also takes "inf" and "nan").
/// Returns whether it is one.
template <class Number>
bool parse_number(std::string_view text, Number& value) {
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  return error == std::errc{} && stop == end;
}

}  // namespace desmo
