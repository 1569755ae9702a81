#include "report/statistics/paper.h"

#include <sstream>

#include "report/text/digits.h"
#include "report/text/embedded.h"

namespace desmo::report {
namespace {

/// Returns the fields of a table, line by line. The first line has the names of the columns.
std::vector<std::vector<std::string>> lines_of(std::string_view table) {
  std::vector<std::vector<std::string>> all;
  std::istringstream lines{std::string(embedded_file(table))};
  for (std::string line; std::getline(lines, line);) {
    std::istringstream fields(line);
    all.emplace_back();
    for (std::string field; std::getline(fields, field, ',');) all.back().push_back(field);
  }
  return all;
}

}  // namespace

std::string published(std::string_view table, std::string_view row, std::string_view column) {
  const auto lines = lines_of(table);
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i)
      if (line.front() == row && lines.front()[i] == column) return line[i];
  return {};
}

const std::vector<std::int64_t>& published_sizes() {
  static const std::vector<std::int64_t> sizes = [] {
    std::vector<std::int64_t> numbers;
    for (const auto& line : lines_of(published_cpu_seconds))
      if (const auto number = read_number(line.front()))
        numbers.push_back(static_cast<std::int64_t>(*number));
    return numbers;
  }();
  return sizes;
}

}  // namespace desmo::report
