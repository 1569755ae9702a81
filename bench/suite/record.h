#pragma once

#include <string>
#include <vector>

#include "bench/suite/cell.h"

namespace desmo::suite {

/// What the record holds beside its cells.
struct Run {
  std::string date;     ///< UTC, when it began
  std::string command;  ///< program name and arguments
  std::vector<double> load_before, load_after;
};

/// Writes the results record (results/record.schema.json) of these cells (at least one), to a file
/// that appears whole or not at all. Throws std::runtime_error, naming the file, when that
/// fails.
void write_record(const std::string& path, const Run& run, const std::vector<Cell*>& cells);

}  // namespace desmo::suite
