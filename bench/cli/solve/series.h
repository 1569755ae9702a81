// Solved instants as text: a table of numbers, one line for each instant.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/solve/columns.h"

namespace desmo::cli {

/// Properties of a series apart from its numbers.
struct SeriesHeading {
  std::string mechanism, scene, formulation;
  std::vector<Column> columns;  ///< the time, which comes first, left out
  bool has_outcomes = false;    ///< each line ends with the outcome of its instant
};

/// Text format of a series. Numbers have the fewest digits that read back as the same double.
class SeriesFormat {
 public:
  virtual ~SeriesFormat() = default;
  virtual std::string heading(const SeriesHeading& heading) const = 0;
  /// Finite numbers: JSON knows no others. An instant without positions has empty cells.
  virtual void append(const SeriesHeading& heading, const Instant& instant, std::string& text,
                      std::string_view outcome = {}) const = 0;
};

/// Returns a format. "csv" has names with units in the first line, "t [s],C.x [m],…". "jsonl" has
/// an object with mechanism, scene, formulation and columns, then an array of numbers for each
/// instant.
std::unique_ptr<SeriesFormat> series_format(std::string_view name);

}  // namespace desmo::cli
