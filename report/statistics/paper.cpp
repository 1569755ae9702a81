#include "report/statistics/paper.h"

#include <charconv>

#include "report/text/embedded.h"

namespace desmo::report {
namespace {

std::vector<std::string> split(std::string_view text, char separator) {
  std::vector<std::string> parts;
  while (true) {
    const auto at = text.find(separator);
    parts.emplace_back(text.substr(0, at));
    if (at == std::string_view::npos) return parts;
    text.remove_prefix(at + 1);
  }
}

}  // namespace

PublishedTable::PublishedTable(std::string_view csv) {
  for (const std::string& line : split(csv, '\n'))
    if (!line.empty()) lines_.push_back(split(line, ','));
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
  for (std::size_t i = 1; i < lines_.size(); ++i) {
    const std::string& row = lines_[i].front();
    std::int64_t size = 0;
    if (std::from_chars(row.data(), row.data() + row.size(), size).ec == std::errc{})
      result.push_back(size);
  }
  return result;
}

std::optional<double> PublishedTable::number(std::string_view row, std::string_view column) const {
  const std::string digits = text(row, column);
  double value = 0;
  const char* const end = digits.data() + digits.size();
  const auto [at, error] = std::from_chars(digits.data(), end, value);
  if (error != std::errc{} || at != end) return std::nullopt;
  return value;
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
