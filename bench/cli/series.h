// Solved instants as text: a table of numbers, one instant a line.
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/columns.h"

namespace desmo::cli {

/// What is known of a series beside its numbers.
struct SeriesHeading {
  std::string mechanism, scene, formulation;
  std::vector<Column> columns;  ///< the time, which comes first, left out
  bool has_outcomes = false;    ///< each line ends with the outcome of its instant
};

/// Numbers are written with the fewest digits that read back as the same double.
class SeriesFormat {
 public:
  virtual ~SeriesFormat() = default;
  virtual std::string heading(const SeriesHeading& heading) const = 0;
  /// Finite numbers: JSON knows no others. An instant without positions has empty cells.
  virtual void append(const SeriesHeading& heading, const Instant& instant, std::string& text,
                      std::string_view outcome = {}) const = 0;
};

/// "csv": names with units in the first line, "t [s],C.x [m],…"; "jsonl": an object that tells
/// mechanism, scene, formulation and columns, then an array of numbers a line.
std::unique_ptr<SeriesFormat> series_format(std::string_view name);

}  // namespace desmo::cli
