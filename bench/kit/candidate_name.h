#pragma once

#include <string>
#include <string_view>

namespace desmo::bench {

/// The name of a candidate, in its pieces.
struct CandidateName {
  std::string case_name;
  int coordinates;
  std::string id;

  std::string text() const;  ///< <case>/<coordinates>/<id>
};

/// Reads what text() returns; throws std::invalid_argument for anything else.
CandidateName parse_name(std::string_view name);

}  // namespace desmo::bench
