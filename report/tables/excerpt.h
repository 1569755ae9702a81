// The few rows of a table that stand in front of an experiment.
#pragma once

#include <algorithm>
#include <functional>
#include <string_view>
#include <vector>

#include "report/text/texts.h"

namespace desmo::report {

inline constexpr std::size_t max_excerpt_rows = 14;

/// Returns the first rows to be kept of a table, in the columns that a block of the texts names.
inline Table excerpt(
    const Table& table, Table head,
    const std::function<bool(const std::vector<Entry>&)>& keep = [](const auto&) { return true; }) {
  std::vector<std::size_t> places;
  for (Column& column : head.columns) {
    const auto found = std::ranges::find(table.columns, column.name, &Column::name);
    places.push_back(static_cast<std::size_t>(found - table.columns.begin()));
    column.quantities = found->quantities;
  }
  for (const auto& row : table.rows) {
    if (head.rows.size() == max_excerpt_rows) break;
    if (!keep(row)) continue;
    auto& kept = head.rows.emplace_back();
    for (const std::size_t place : places) kept.push_back(row[place]);
  }
  return head;
}

/// Tells whether a row is of the case that stands last: the truck, where both cases were measured.
inline bool is_of_last_case(const Table& table, const std::vector<Entry>& row) {
  return row.front().shown == table.rows.back().front().shown;
}

}  // namespace desmo::report
