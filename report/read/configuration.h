// The meaning of an id: a formulation and its settings.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// A formulation and its settings as an id names them. The defaults are the paper's.
struct Configuration {
  std::string formulation = {};  ///< <partition>_<equations>_<algebra>
  std::string guess = "previous", jacobian = "newton";
  /// End of a step: a fixed number of `iterations`; without one, the tolerance. Where both are
  /// empty, the tolerance of the record's settings.
  std::string iterations = {}, tolerance = {};
  /// All other suffixes: "lanes:8", "check:proof", and "scalar:float" of earlier records.
  std::vector<std::string> others = {};

  /// Returns whether `others` is empty: settings differ from the paper's only in the iteration,
  /// that is in guess, Jacobian, and where a step stops.
  bool has_papers_algorithm() const;
  /// Returns whether all settings are the paper's, except for where a step stops.
  bool has_papers_settings() const;
  /// Returns whether all settings are the paper's.
  bool is_papers() const;
  /// Returns whether guess, iterations and tolerance are the same.
  bool iterates_like(const Configuration& other) const;
  /// Returns whether no instant is interpolated between solved ones.
  bool solves_every_instant() const;
  bool operator==(const Configuration&) const = default;
};

/// Returns the configuration that an id names. Returns nothing when the formulation is empty, a key
/// is given twice, or a suffix is neither "/key:value" nor a mark. A mark is a word alone, such as
/// "/monitored" in older records, that is not "guess", "jacobian", "iterations" or "tolerance".
std::optional<Configuration> parse_configuration(std::string_view id);

}  // namespace desmo::report
