#include "bench/kit/options.h"

#include <charconv>
#include <stdexcept>
#include <string>

namespace desmo::bench {

int whole_number(std::string_view text, int min, int max) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value < min || value > max)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number from " +
                                std::to_string(min) + " to " + std::to_string(max));
  return value;
}

}  // namespace desmo::bench
