#pragma once

#include <cstdarg>
#include <cstdio>
#include <string>

namespace desmo {

/// Returns what printf() would print.
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

}  // namespace desmo
