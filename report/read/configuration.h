// The meaning of an id: a formulation and its settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// Settings as ids name them; the defaults are the paper's, which ids leave out.
struct Configuration {
  std::string formulation;  ///< <partition>_<equations>_<algebra>
  std::string guess = "previous", jacobian = "newton", factorisation = "shared", scalar = "double";
  std::string iterations, tolerance;  ///< end of a step; both empty: the usual tolerance
  std::vector<std::string> others;    ///< any other suffixes, "key:value"

  /// Returns whether all but where a step stops is as in the paper.
  bool has_papers_settings() const;
  /// Returns whether no instant is interpolated between solved ones.
  bool solves_every_instant() const;
  bool operator==(const Configuration&) const = default;
};

/// Returns nothing when a suffix is no "/key:value" or its key is given twice.
std::optional<Configuration> parse_configuration(std::string_view id);

}  // namespace desmo::report
