#include "bench/kit/candidate_name.h"

#include <stdexcept>

#include "cases/mechanism/formatted.h"

namespace desmo::bench {

std::string CandidateName::text() const {
  return case_name + "/" + std::to_string(coordinates) + "/" + id;
}

CandidateName parse_name(std::string_view name) {
  const std::size_t first = name.find('/'), second = name.find('/', first + 1);
  int coordinates = -1;
  if (second == std::string_view::npos || second + 1 == name.size() ||
      !parse_number(name.substr(first + 1, second - first - 1), coordinates) || coordinates < 0)
    throw std::invalid_argument("'" + std::string(name) +
                                "' is not of the form <case>/<coordinates>/<id>");
  return {std::string(name.substr(0, first)), coordinates, std::string(name.substr(second + 1))};
}

int whole_number(std::string_view text, int min, int max) {
  int value = 0;
  if (!parse_number(text, value) || value < min || value > max)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number from " +
                                std::to_string(min) + " to " + std::to_string(max));
  return value;
}

}  // namespace desmo::bench
