#include "bench/kit/candidate_name.h"

#include <limits>
#include <stdexcept>

#include "bench/kit/options.h"

namespace desmo::bench {

std::string CandidateName::text() const {
  return case_name + "/" + std::to_string(coordinates) + "/" + id;
}

CandidateName parse_name(std::string_view name) {
  const std::size_t first = name.find('/'), second = name.find('/', first + 1);
  try {
    if (second != std::string_view::npos && second + 1 < name.size())
      return {std::string(name.substr(0, first)),
              whole_number(name.substr(first + 1, second - first - 1), 0,
                           std::numeric_limits<int>::max()),
              std::string(name.substr(second + 1))};
  } catch (const std::invalid_argument&) {  // no number of coordinates
  }
  throw std::invalid_argument("'" + std::string(name) +
                              "' is not of the form <case>/<coordinates>/<id>");
}

}  // namespace desmo::bench
