#include <algorithm>
#include <cmath>

#include "cases/io/csv.h"
#include "cases/io/readers.h"
#include "cases/mechanism/names.h"

namespace desmo {
namespace {

class TableFile {
 public:
  TableFile(const JsonValue& place, NamedFiles::Text file, std::string_view column,
            const DisplayUnit& unit, std::span<const DisplayUnit> units)
      : place_(place), file_(std::move(file)), column_(column), unit_(unit), units_(units) {}

  MotionTable read() {
    std::string_view rest = file_.text;
    while (!rest.empty()) {
      const std::string_view line = rest.substr(0, rest.find('\n'));
      rest.remove_prefix(std::min(rest.size(), line.size() + 1));
      ++line_;
      if (!trimmed(line).empty()) read_line(line);
    }
    if (table_.times.size() < 2) {
      line_ = 0;
      fail("has " + std::to_string(table_.times.size()) + " rows; a table needs 2 or more");
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
        fail("has " + std::to_string(width_) + " columns and no heading; give two, t and " +
             in_quotes(column_) + ", or name them in the first line");
    }
    if (fields_.size() != width_)
      fail("has " + std::to_string(fields_.size()) + " columns, where " + std::to_string(width_) +
           " are expected");
    const double t = number(time_);
    if (!table_.times.empty() && !(t > table_.times.back()))
      fail("its time is not after the one before; give ascending times");
    table_.times.push_back(t);
    table_.values.push_back(number(values_) * unit_.in_si);
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
    time_ = find("t", 0);
    values_ = find(column_, 1);
    if (time_ == values_) fail("has one column for times and values; give two");
    if (const ColumnHeading t = column_heading(fields_[time_]); t.has_unit && t.unit != "s")
      fail("times are in " + in_quotes(t.unit) + "; give seconds, [s]");
    const ColumnHeading z = column_heading(fields_[values_]);
    if (!z.has_unit) return;
    const auto unit = std::ranges::find(units_, z.unit, &DisplayUnit::name);
    if (unit == units_.end() || (unit->name == "1") != (unit_.name == "1"))
      fail("values are in " + in_quotes(z.unit) + ", no unit that they can have; give another");
    unit_ = *unit;
  }

  double number(std::size_t column) const {
    constexpr double max_number = 1e100;
    double value = 0;
    if (!to_number(fields_[column], value) || !(std::abs(value) <= max_number))
      fail("column " + std::to_string(column + 1) + ": " + in_quotes(fields_[column]) +
           " is not a number up to 1e100");
    return value;
  }

  [[noreturn]] void fail(const std::string& what) const {
    place_.complain("the table file '" + printable(file_.name, 300) +
                    "': " + (line_ > 0 ? "line " + std::to_string(line_) + ": " : "") + what);
  }

  const JsonValue& place_;
  NamedFiles::Text file_;
  std::string_view column_;
  DisplayUnit unit_;
  std::span<const DisplayUnit> units_;
  MotionTable table_;
  long line_ = 0;
  std::size_t width_ = 0, time_ = 0, values_ = 1;
  std::vector<std::string_view> fields_;
};

}  // namespace

MotionTable read_table_file(const JsonValue& value, NamedFiles& files, std::string_view column,
                            const DisplayUnit& unit, std::span<const DisplayUnit> units) {
  return TableFile(value, files.read_named(value, "table"), column, unit, units).read();
}

}  // namespace desmo
