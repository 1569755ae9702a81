#include "bench/cli/solve/driver_rows.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <set>

#include "bench/cli/errors.h"
#include "cases/io/csv.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

constexpr std::size_t max_line = std::size_t{1} << 20;  // bytes of a line (≤)

}  // namespace

DriverRows::DriverRows(const std::string& path, const Model& whole, const Model& model, Level level,
                       const DisplayUnits& units)
    : source_(path == "-" ? "standard input" : printable(path, 300)),
      file_(path == "-" ? stdin : std::fopen(path.c_str(), "r"),
            path == "-" ? +[](std::FILE*) { return 0; } : &std::fclose),
      level_(static_cast<int>(level)) {
  if (!file_)
    throw CommandError(unreadable_input, source_ + ": cannot be read (" + std::strerror(errno) +
                                             "); give a file of driver values, or -");
  for (const Driver& d : whole.drivers) {
    columns_.push_back(columns_of(whole, {d.coordinate, Level::acceleration}, units));
    const auto solved = std::ranges::find(
        model.drivers, whole.entities[d.coordinate].name,
        [&](const Driver& other) { return model.entities[other.coordinate].name; });
    wanted_.push_back(
        solved == model.drivers.end() ? -1 : static_cast<int>(solved - model.drivers.begin()));
  }
  for (std::vector<double>& values : values_) values.resize(model.drivers.size());
}

std::string DriverRows::place() const { return source_ + ": line " + std::to_string(line_); }

void DriverRows::fail(std::size_t column, const std::string& what) const {
  throw InputError(place() + ", column " + std::to_string(column + 1) + ": " + what);
}

bool DriverRows::read_line(std::string& line) {
  line.clear();
  for (int c; (c = std::getc(file_.get())) != EOF && c != '\n';) {
    line += static_cast<char>(c);
    if (line.size() > max_line) {
      ++line_;
      fail(0, "the line is longer than 1 MiB; write one row a line");
    }
  }
  if (std::ferror(file_.get()))
    throw CommandError(unreadable_input,
                       source_ + ": cannot be read (" + std::strerror(errno) + ")");
  if (line.empty() && std::feof(file_.get())) return false;
  if (++line_ == 1) line.erase(0, line.size() - without_mark(line).size());
  return true;
}

/// Sets the targets of columns by their names in a heading.
void DriverRows::read_heading(const std::vector<std::string_view>& fields) {
  targets_.assign(fields.size(), {});
  time_column_ = fields.size();
  std::set<std::string_view> seen;
  for (std::size_t k = 0; k < fields.size(); ++k) {
    const auto [name, given, has_unit] = column_heading(fields[k]);
    const auto takes = [&, name = name, given = given,
                        has_unit = has_unit](const std::string& unit) {
      if (!seen.insert(name).second)
        fail(k, desmo::in_quotes(std::string(name)) + " stands there twice; leave one out");
      if (has_unit && given != unit)
        fail(k, desmo::in_quotes(fields[k]) + ": the unit is " + unit +
                    (unit == "s" ? "" : " (with --units si, that of SI)"));
    };
    if (name == "t") {
      takes("s");
      time_column_ = k;
    }
    for (int order = 0; order < 3; ++order)
      for (std::size_t d = 0; d < wanted_.size(); ++d)
        if (name == columns_[d][order].name) {
          takes(columns_[d][order].unit.name);
          targets_[k] = {order, d};
        }
  }
  if (time_column_ == fields.size()) fail(0, "there is no column t; name one");
  for (int order = 0; order <= level_; ++order)
    for (std::size_t d = 0; d < wanted_.size(); ++d)
      if (wanted_[d] >= 0 && !seen.contains(columns_[d][order].name))
        fail(0, "there is no column " + desmo::in_quotes(columns_[d][order].name) + "; name one");
}

/// Sets the targets of columns without a heading. fields: number of columns in the first row.
void DriverRows::read_first(std::size_t fields) {
  const std::size_t drivers = wanted_.size();
  targets_.assign(1, {});
  for (int order = 0; order < 3 && targets_.size() < fields; ++order)
    for (std::size_t d = 0; d < drivers; ++d) targets_.push_back({order, d});
  const std::size_t needed = 1 + drivers * (level_ + 1);
  if (targets_.size() == fields && fields >= needed) return;
  std::string names = "t [s]";
  for (int order = 0; order <= level_; ++order)
    for (const std::vector<Column>& driver : columns_) names += "," + driver[order].heading();
  fail(fields < needed ? fields : targets_.size(),
       std::to_string(fields) + " numbers, where " + std::to_string(needed) +
           " are needed; write " + printable(names, 500));
}

bool DriverRows::next(LiveRow& row) {
  do
    if (!read_line(text_)) return false;
  while (trimmed(text_).empty());
  split_fields(text_, fields_);
  double value = 0;
  if (targets_.empty() && !to_number(fields_[0], value)) {
    read_heading(fields_);
    return next(row);
  }
  if (targets_.empty()) read_first(fields_.size());
  if (fields_.size() != targets_.size())
    fail(std::min(fields_.size(), targets_.size()),
         std::to_string(fields_.size()) + " numbers, where " + std::to_string(targets_.size()) +
             " are expected; write as many");
  for (std::size_t k = 0; k < fields_.size(); ++k) {
    const auto& [order, driver] = targets_[k];
    if (k != time_column_ && (order < 0 || wanted_[driver] < 0)) continue;
    if (!to_number(fields_[k], value))
      fail(k, desmo::in_quotes(std::string(fields_[k])) + " is not a number; write one");
    if (k == time_column_)
      row.time = value;
    else
      values_[order][wanted_[driver]] = columns_[driver][order].unit.to_si(value);
  }
  row.z = values_[0];
  row.zd = values_[1];
  row.zdd = values_[2];
  return true;
}

}  // namespace desmo::cli
