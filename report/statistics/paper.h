// The tables of the paper. results/paper/*.csv is their only home; the build embeds them.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace desmo::report {

// Tables, by their files.
inline constexpr std::string_view published_cpu_seconds = "table1_cpu_seconds.csv";
inline constexpr std::string_view published_speed_up = "table2_speedup.csv";
/// Improvements, in brackets in table 2.
inline constexpr std::string_view published_improvement_percent = "table2_improvement_percent.csv";

/// Returns what the paper prints in a row ("114" ... "558", "mean") and a column of a table; empty
/// where it prints nothing. A text: "<<0.015" stands where another would print a number.
std::string published(std::string_view table, std::string_view row, std::string_view column);

inline constexpr double published_duration = 30;  ///< s, of motion, of every published time

/// Numbers of coordinates of both tables, ascending.
const std::vector<std::int64_t>& published_sizes();

}  // namespace desmo::report
