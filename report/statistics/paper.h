// The tables of the paper. results/paper/*.csv is their only home; the build embeds them.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

/// A published table, as text: the paper prints "<<0.015" where another would print a number.
class PublishedTable {
 public:
  explicit PublishedTable(std::string_view csv);

  /// Returns what the paper prints for a row ("114" ... "558", "mean") and one of its columns;
  /// empty where it prints nothing.
  std::string text(std::string_view row, std::string_view column) const;
  std::optional<double> number(std::string_view row, std::string_view column) const;

  std::vector<std::int64_t> sizes() const;  ///< the rows that are numbers, in their order

 private:
  std::vector<std::vector<std::string>> lines_;  // the first holds the names of the columns
};

inline constexpr double published_duration = 30;  ///< s, of motion, of every published time

const PublishedTable& published_cpu_seconds();          ///< table 1
const PublishedTable& published_speed_up();             ///< table 2
const PublishedTable& published_improvement_percent();  ///< table 2, in brackets

/// Numbers of coordinates of both tables, ascending.
const std::vector<std::int64_t>& published_sizes();

}  // namespace desmo::report
