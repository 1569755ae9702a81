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

/// Reads a whole number of a command line. Throws std::invalid_argument, naming the text, unless it
/// is one from min to max.
int whole_number(std::string_view text, int min, int max);

}  // namespace desmo::bench
