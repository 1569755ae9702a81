#include <algorithm>
#include <array>
#include <cmath>

#include "cases/io/csv.h"
#include "cases/io/readers.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

class TableFile {
 public:
  TableFile(const JsonValue& place, NamedFiles::Text file, const TableColumn& arguments,
            const TableColumn& values)
      : place_(place), file_(std::move(file)), columns_{arguments, values} {}

  Table read() {
    std::string_view rest = file_.text;
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(rest.size(), line.size() + 1));
      ++line_;
      if (!trimmed(line).empty()) read_line(line);
    }
    if (table_.arguments.size() < 2) {
      line_ = 0;
      fail("has " + std::to_string(table_.arguments.size()) + " rows; a table needs 2 or more");
    }
    return std::move(table_);
  }

 private:
  void read_line(std::string_view line) {
    split_fields(line, fields_);
    double ignored;
    if (width_ == 0) {
      width_ = fields_.size();
      if (!to_number(fields_.front(), ignored)) return read_heading();
      if (width_ != 2)
        fail("has " + std::to_string(width_) + " columns and no heading; give two, " +
             std::string(columns_[0].name) + " and " + in_quotes(columns_[1].name) +
             ", or name them in the first line");
    }
    if (fields_.size() != width_)
      fail("has " + std::to_string(fields_.size()) + " columns, where " + std::to_string(width_) +
           " are expected");
    const double t = number(0);
    if (!table_.arguments.empty() && !(t > table_.arguments.back()))
      fail("its " + noun() + " is not after the one before; give ascending " + noun() + "s");
    table_.arguments.push_back(t);
    table_.values.push_back(number(1));
  }

  void read_heading() {
    std::vector<std::string_view> names;
    for (const std::string_view field : fields_) names.push_back(column_heading(field).name);
    const auto find = [&](std::string_view name, std::size_t otherwise) {
      const auto found = std::ranges::find(names, name);
      if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
      if (width_ == 2) return otherwise;
      fail("no column is called " + in_quotes(name) + "; " + suggestion(name, names));
    };
    for (const std::size_t i : {0, 1}) at_[i] = find(columns_[i].name, i);
    if (at_[0] == at_[1]) fail("has one column for " + noun() + "s and values; give two");
    for (const std::size_t i : {0, 1}) read_unit(columns_[i], column_heading(fields_[at_[i]]));
  }

  void read_unit(TableColumn& column, const ColumnHeading& heading) const {
    if (!heading.has_unit) return;
    const auto unit = std::ranges::find(column.units, heading.unit, &DisplayUnit::name);
    if (unit == column.units.end() || (unit->name == "1") != (column.unit.name == "1"))
      fail(column.name == "t" ? "times are in " + in_quotes(heading.unit) + "; give seconds, [s]"
                              : "values are in " + in_quotes(heading.unit) +
                                    ", no unit that they can have; give another");
    column.unit = *unit;
  }

  std::string noun() const { return columns_[0].name == "t" ? "time" : "argument"; }

  double number(int of) const {
    constexpr double max_number = 1e100;
    const std::size_t column = at_[of];
    double value = 0;
    if (!to_number(fields_[column], value) || !(std::abs(value) <= max_number))
      fail("column " + std::to_string(column + 1) + ": " + in_quotes(fields_[column]) +
           " is not a number up to 1e100");
    return value * (columns_[of].unit.in_si / columns_[of].result);
  }

  [[noreturn]] void fail(const std::string& what) const {
    place_.complain("the table file '" + printable(file_.name, 300) +
                    "': " + (line_ > 0 ? "line " + std::to_string(line_) + ": " : "") + what);
  }

  const JsonValue& place_;
  NamedFiles::Text file_;
  std::array<TableColumn, 2> columns_;  // arguments, values
  Table table_;
  long line_ = 0;
  std::size_t width_ = 0;
  std::array<std::size_t, 2> at_{0, 1};  // of these columns
  std::vector<std::string_view> fields_;
};

Table read_lists(const JsonValue& value, const TableColumn& of_arguments,
                 const TableColumn& of_values) {
  const JsonValue arguments = value[of_arguments.key], values = value[of_values.key];
  const auto numbers = [](const JsonValue& list, const TableColumn& column) {
    std::vector<double> result;
    for (const JsonValue& x : list.elements())
      result.push_back(x.number() * (column.unit.in_si / column.result));
    return result;
  };
  const Table table{numbers(arguments, of_arguments), numbers(values, of_values)};
  const std::size_t count = table.arguments.size();
  const std::string noun = of_arguments.name == "t" ? "time" : "argument";
  if (count != table.values.size())
    values.complain("has " + std::to_string(table.values.size()) + " values for " +
                    std::to_string(count) + " " + noun + "s; give as many");
  if (count < 2)
    arguments.complain("has " + std::to_string(count) + " " + noun + "s; a table needs 2 or more");
  for (std::size_t i = 1; i < count; ++i)
    if (!(table.arguments[i] > table.arguments[i - 1]))
      arguments.elements()[i].complain("is not after the " + noun + " before it; give ascending " +
                                       noun + "s");
  return table;
}

}  // namespace

Table read_table(const JsonValue& value, NamedFiles& files, const TableColumn& arguments,
                 const TableColumn& values) {
  const auto file = value.find("file");
  if (!file) return read_lists(value, arguments, values);
  if (value.find(arguments.key) || value.find(values.key))
    value.complain("has a file, and lists as well; give one of them");
  return TableFile(*file, files.read_named(*file, "table"), arguments, values).read();
}

SplineEnds read_ends(const JsonValue& table, bool may_index) {
  static constexpr std::array<std::string_view, 4> names{"natural", "clamped", "periodic",
                                                         "indexing"};
  constexpr std::array ends{SplineEnds::natural, SplineEnds::clamped, SplineEnds::periodic,
                            SplineEnds::indexing};
  const auto given = table.find("ends");
  if (!given) return SplineEnds::natural;
  return ends[given->choose("ends", std::span(names).first(may_index ? 4 : 3))];
}

}  // namespace desmo
