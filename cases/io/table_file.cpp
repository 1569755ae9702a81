#include <algorithm>
#include <array>
#include <cmath>

#include "cases/io/csv.h"
#include "cases/io/readers.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

/// Reader of a table from a CSV file.
struct TableFile {
  const JsonValue& place;  // value that names the file, for messages
  NamedFiles::Text file;
  const std::vector<Mechanism::Coordinate>& coordinates;
  std::array<TableColumn*, 2> columns;     // arguments, values
  long lines = 0;                          // number of lines that were read
  std::size_t width = 0;                   // number of fields in each line; 0: none was read yet
  std::array<std::size_t, 2> at{0, 1};     // indices of the fields of `columns` in a line
  std::vector<std::string_view> fields{};  // fields of the current line

  void read() {
    std::string_view rest = without_mark(file.text);
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(rest.size(), line.size() + 1));
      ++lines;
      if (!trimmed(line).empty()) read_line(line);
    }
    const std::size_t rows = columns[0]->numbers.size();
    if (rows >= 2) return;
    lines = 0;
    fail("has " + std::to_string(rows) + " rows; a table needs 2 or more");
  }

  void read_line(std::string_view line) {
    split_fields(line, fields);
    double ignored;
    if (width == 0) {
      width = fields.size();
      if (!to_number(fields.front(), ignored)) return read_heading();
      if (width != 2)
        fail("has " + std::to_string(width) + " columns and no heading; give two, " + name(0) +
             " and " + name(1) + ", or name them in the first line");
    }
    if (fields.size() != width)
      fail("has " + std::to_string(fields.size()) + " columns, where " + std::to_string(width) +
           " are expected; give as many");
    const std::vector<double>& arguments = columns[0]->numbers;
    for (const int i : {0, 1}) columns[i]->numbers.push_back(number(at[i]));
    if (arguments.size() > 1 && !(arguments.back() > arguments[arguments.size() - 2]))
      fail("its " + name(0) + " is not above the one before; give ascending ones");
  }

  void read_heading() {
    std::vector<std::string_view> names;
    for (const std::string_view field : fields) names.push_back(column_heading(field).name);
    for (const int i : {0, 1}) {
      const auto found = std::ranges::find(names, columns[i]->name);
      if (found != names.end())
        at[i] = static_cast<std::size_t>(found - names.begin());
      else if (width != 2)
        fail("no column is called " + name(i) + "; " + remedy(suggestion(columns[i]->name, names)));
      else if (double number; to_number(fields[i], number))
        fail("column 1: " + in_quotes(fields.front()) + " is not a number, and column " +
             std::to_string(i + 1) + ", " + in_quotes(fields[i]) +
             ", is not a name; give two numbers or two names");
      else if (names[i] == columns[1 - i]->name || is_time_among_values(i, names[i]) ||
               std::ranges::count(coordinates, names[i], &Mechanism::Coordinate::name) > 0)
        fail("column " + std::to_string(i + 1) + " is called " + in_quotes(names[i]) + ", where " +
             name(i) + " is expected; correct the heading");
    }
    if (at[0] == at[1])
      fail("column " + std::to_string(at[0] + 1) + ", " + name(0) +
           ", would be arguments and values; rename the coordinate, or leave the heading out");
    for (const int i : {0, 1})
      if (std::ranges::count(names, columns[i]->name) > 1)
        fail("two columns are called " + name(i) + "; leave one out");
    for (const int i : {0, 1}) read_unit(*columns[i], column_heading(fields[at[i]]));
  }

  /// Returns whether a column of values is called "time", while times are the arguments.
  bool is_time_among_values(int column, std::string_view heading) const {
    return column == 1 && columns[0]->name == "t" && (heading == "time" || heading == "Time");
  }

  void read_unit(TableColumn& column, const ColumnHeading& heading) const {
    if (!heading.has_unit) return;
    const auto unit = std::ranges::find(column.units, heading.unit, &DisplayUnit::name);
    if (unit == column.units.end() || (unit->name == "1") != (column.unit.name == "1"))
      fail(in_quotes(column.name) + " is in " + in_quotes(heading.unit) +
           ", no unit that it can have; give it in " + in_quotes(column.unit.name));
    column.unit = *unit;
  }

  std::string name(int column) const { return in_quotes(columns[column]->name); }

  double number(std::size_t column) const {
    constexpr double max_number = 1e100;
    double value = 0;
    if (!to_number(fields[column], value) || !(std::abs(value) <= max_number))
      fail("column " + std::to_string(column + 1) + ": " + in_quotes(fields[column]) +
           " is not a number up to 1e100; " + remedy("give one"));
    return value;
  }

  /// Returns the usual remedy; for a line with a semicolon, which does not separate, one about
  /// separators.
  std::string remedy(const std::string& usual) const {
    const auto has_semicolon = [](std::string_view field) { return field.find(';') != field.npos; };
    return std::ranges::none_of(fields, has_semicolon)
               ? usual
               : "separate columns by commas, tabs or blanks, and write decimal points";
  }

  [[noreturn]] void fail(const std::string& what) const {
    place.complain("the table file '" + printable(file.name, 300) +
                   "': " + (lines > 0 ? "line " + std::to_string(lines) + ": " : "") + what);
  }
};

void read_lists(const JsonValue& table, TableColumn& arguments, TableColumn& values) {
  for (TableColumn* const column : {&arguments, &values})
    for (const JsonValue& x : table[column->key].elements()) column->numbers.push_back(x.number());
  const std::size_t count = arguments.numbers.size();
  const JsonValue list = table[arguments.key];
  if (count != values.numbers.size())
    table[values.key].complain("has " + std::to_string(values.numbers.size()) + " numbers, and " +
                               in_quotes(arguments.key) + " " + std::to_string(count) +
                               "; give as many");
  if (count < 2)
    list.complain("has " + std::to_string(count) + " numbers; a table needs 2 or more");
  for (std::size_t i = 1; i < count; ++i)
    if (!(arguments.numbers[i] > arguments.numbers[i - 1]))
      list.elements()[i].complain("is not above the number before it; give ascending ones");
}

}  // namespace

TableColumn column_of(std::string_view key, const Mechanism::Coordinate& coordinate,
                      const DisplayUnits& units) {
  const bool is_angle = coordinate.is_angle();
  return {key, coordinate.name, units.of(is_angle), known_units(is_angle)};
}

void read_table(const JsonValue& value, NamedFiles& files,
                const std::vector<Mechanism::Coordinate>& coordinates, TableColumn& arguments,
                TableColumn& values) {
  const auto file = value.find("file");
  if (!file) return read_lists(value, arguments, values);
  if (value.find(arguments.key) || value.find(values.key))
    value.complain("has a file, and lists as well; give one of them");
  TableFile{*file, files.read_named(*file, "table"), coordinates, {&arguments, &values}}.read();
}

SplineEnds read_ends(const JsonValue& table, bool may_index) {
  const auto given = table.find("ends");
  if (!given) return SplineEnds::natural;
  return static_cast<SplineEnds>(
      given->choose("ends", std::span(ends_names).first(may_index ? 4 : 3)));
}

}  // namespace desmo
