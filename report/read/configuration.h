// The meaning of an id: a formulation and its settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// Settings as ids name them; the defaults are the paper's, which ids leave out.
struct Configuration {
  std::string formulation = {};  ///< <partition>_<equations>_<algebra>
  std::string guess = "previous", jacobian = "newton";
  std::string iterations = {}, tolerance = {};  ///< end of a step; both empty: the usual tolerance
  /// Any other suffixes: "lanes:8", "check:proof", and "scalar:float" of earlier records.
  std::vector<std::string> others = {};

  /// Returns whether nothing differs from the paper but settings of the iteration: guess, Jacobian,
  /// and where a step stops. A run that is checked, several instants at once, or an option of the
  /// linear solver is something else.
  bool has_papers_algorithm() const;
  /// Returns whether all but where a step stops is as in the paper.
  bool has_papers_settings() const;
  /// Returns whether everything is as in the paper.
  bool is_papers() const;
  /// Returns whether steps start from the same guess and stop at the same place.
  bool iterates_like(const Configuration& other) const;
  /// Returns whether no instant is interpolated between solved ones.
  bool solves_every_instant() const;
  bool operator==(const Configuration&) const = default;
};

/// Returns nothing when a suffix is neither "/key:value" nor a mark, such as "/monitored" in older
/// records, or is given twice. The keys of the settings above make no marks.
std::optional<Configuration> parse_configuration(std::string_view id);

}  // namespace desmo::report
