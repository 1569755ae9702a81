#include "report/statistics/paper.h"

#include <sstream>

#include "report/text/digits.h"
#include "report/text/embedded.h"

namespace desmo::report {

PublishedTable::PublishedTable(std::string_view csv) {
  std::istringstream lines{std::string(csv)};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    lines_.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) lines_.back().push_back(field);
  }
}

std::string PublishedTable::text(std::string_view row, std::string_view column) const {
  const std::vector<std::string>& names = lines_.front();
  for (const auto& line : lines_)
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line.front() == row && names[i] == column) return line[i];
  return {};
}

std::vector<std::int64_t> PublishedTable::sizes() const {
  std::vector<std::int64_t> result;
  for (const auto& line : lines_)
    if (const auto size = read_number(line.front()))
      result.push_back(static_cast<std::int64_t>(*size));
  return result;
}

std::optional<double> PublishedTable::number(std::string_view row, std::string_view column) const {
  return read_number(text(row, column));
}

const PublishedTable& published_cpu_seconds() {
  static const PublishedTable table(embedded_file("table1_cpu_seconds.csv"));
  return table;
}

const PublishedTable& published_speed_up() {
  static const PublishedTable table(embedded_file("table2_speedup.csv"));
  return table;
}

const PublishedTable& published_improvement_percent() {
  static const PublishedTable table(embedded_file("table2_improvement_percent.csv"));
  return table;
}

const std::vector<std::int64_t>& published_sizes() {
  static const std::vector<std::int64_t> sizes = published_cpu_seconds().sizes();
  return sizes;
}

}  // namespace desmo::report
