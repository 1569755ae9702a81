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

/// Reader of driver values, line by line: the time t, then the coordinate z of each driver, ż of
/// each and z̈ of each. They are in the order of the scene's drivers and in the units of the
/// output. Commas or blanks separate the numbers. Empty lines are skipped. A first line that does
/// not begin with a number is a heading: it names the columns as the output does ("t [s],theta
/// [rad],d/dt theta [rad/s]"; units may be left out), in any order. Columns that belong to no
/// driver are then ignored.
class DriverRows {
 public:
  /// Opens a file, or standard input for "-". Throws CommandError (unreadable_input).
  /// - whole: model of the scene; without a heading, its drivers have the columns, in their order
  /// - model: model that is solved; the values of its drivers alone are read
  /// - level: highest level that is needed
  /// - units: units of the rows
  DriverRows(const std::string& path, const Model& whole, const Model& model, Level level,
             const DisplayUnits& units);

  /// Reads the next row, which stays valid until next() is called again. Returns false at the end.
  /// Throws InputError, naming line and column, and CommandError (unreadable_input).
  bool next(LiveRow& row);

  /// Returns the place of the line read last: "drivers.csv: line 3".
  std::string place() const;

 private:
  /// Place at which the numbers of a column are stored.
  struct Target {
    int level = -1;          // 0: z, 1: ż, 2: z̈; -1: not stored, or the time
    std::size_t driver = 0;  // index in the drivers of `whole`
  };
  bool read_line(std::string& line);
  void read_heading(const std::vector<std::string_view>& fields);
  void read_first(std::size_t fields);
  [[noreturn]] void fail(std::size_t column, const std::string& what) const;

  std::string source_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
  std::vector<std::vector<Column>> columns_;  // by driver of `whole`: its column at each level
  std::vector<int> wanted_;  // by driver of `whole`: its index in a LiveRow; -1: it is not solved
  int level_;
  long line_ = 0;
  std::string text_;
  std::vector<std::string_view> fields_;
  std::size_t time_column_ = 0;
  std::vector<Target> targets_;  // by column of the input; empty until its first line is read
  std::vector<double> values_[3];
};

}  // namespace desmo::cli
