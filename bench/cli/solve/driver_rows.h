// Driver values as text: one row a line, from a file or as they come through a pipe.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/cli/solve/columns.h"
#include "formulations/base/live_row.h"
#include "formulations/model/model.h"

namespace desmo::cli {

/// Reader of driver values, line by line: t, then z of each driver, ż of each and z̈ of each, in
/// the order of the model's drivers and in the units of the output. Commas or blanks separate the
/// numbers. Empty lines are skipped. A first line that does not begin with a number is a heading:
/// it names the columns as the output does ("t [s],theta [rad],d/dt theta [rad/s]"; units may be
/// left out), in any order. Columns that belong to no driver are then ignored.
class DriverRows {
 public:
  /// Opens a file, or standard input for "-". Throws CommandError (unreadable_input).
  /// - whole: its drivers have the columns, where there is no heading
  /// - model: its drivers are read
  /// - level: highest level that is needed
  /// - units: of the rows
  DriverRows(const std::string& path, const Model& whole, const Model& model, Level level,
             const DisplayUnits& units);

  /// Reads the next row, which is valid until the one after it. Returns false at the end. Throws
  /// InputError, naming line and column, and CommandError (unreadable_input).
  bool next(LiveRow& row);

  /// "drivers.csv: line 3", of the row read last.
  std::string place() const;

 private:
  /// The target of a number of a line.
  struct Target {
    int level = -1;  // of z, ż, z̈; -1: nowhere
    std::size_t driver = 0;
  };
  bool read_line(std::string& line);
  void read_heading(const std::vector<std::string_view>& fields);
  void read_first(std::size_t fields);
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  std::string source_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::vector<Column>> columns_;  // by driver of `whole`, then by level
  std::vector<int> wanted_;                   // by driver: its place in rows, or -1
  int level_;
  long line_ = 0;
  std::string text_;
  std::vector<std::string_view> fields_;
  std::size_t time_column_ = 0;
  std::vector<Target> targets_;  // by column, once known
  std::vector<double> values_[3];
};

}  // namespace desmo::cli
