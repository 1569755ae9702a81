// The tables of the paper, which the build embeds from results/paper/*.csv.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

// File names of the tables.
inline constexpr std::string_view published_cpu_seconds = "table1_cpu_seconds.csv";
inline constexpr std::string_view published_speed_up = "table2_speedup.csv";
/// Improvements [%], which table 2 has in brackets.
inline constexpr std::string_view published_improvement_percent = "table2_improvement_percent.csv";

/// Returns what the paper prints in a row ("114" ... "558", "mean") and a column of a table; empty
/// where it prints nothing. Not every entry is a number: table 1 has "<<0.015".
std::string published(std::string_view table, std::string_view row, std::string_view column);

inline constexpr double published_duration = 30;  ///< duration of the motion of every time [s]

/// Returns the numbers of coordinates in table 1, ascending; table 2 has the same.
const std::vector<std::int64_t>& published_sizes();

}  // namespace desmo::report
