#include "bench/kit/options.h"

#include <stdexcept>
#include <string>

#include "cases/mechanism/formatted.h"

namespace desmo::bench {

int whole_number(std::string_view text, int min, int max) {
  int value = 0;
  if (!parse_number(text, value) || value < min || value > max)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number from " +
                                std::to_string(min) + " to " + std::to_string(max));
  return value;
}

}  // namespace desmo::bench
