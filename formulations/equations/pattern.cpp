#include "formulations/equations/pattern.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <stdexcept>

#include "formulations/base/index_range.h"

namespace desmo {

PatternWithSlots make_pattern(const Model& m, const PartDefinition& part,
                              std::span<const JacobianEntry> entries) {
  Pattern p;
  p.n = static_cast<int>(part.unknowns.size());
  p.unknowns = part.unknowns;

  // Order: unknown columns ascending with rows ascending; then known columns by row; then entries
  // that are not read.
  const auto rank = [&](const JacobianEntry& e) {
    constexpr std::array unread{2, 0, 0};
    if (e.row < 0) return unread;
    if (const int column = position_in(p.unknowns, e.place); column >= 0)
      return std::array{0, column, e.row};
    return e.resting ? unread : std::array{1, e.row, e.place};
  };
  std::vector<std::array<int, 3>> ranks;
  for (const JacobianEntry& e : entries) ranks.push_back(rank(e));
  std::vector<int> order(entries.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int i) { return ranks[i]; });

  std::vector<int> slots(entries.size());
  p.column_start.assign(p.n + 1, 0);
  std::array<int, 3> previous{-1, -1, -1};
  for (const int i : order) {
    const auto& r = ranks[i];
    if (r[0] < 2 && r == previous)
      throw std::invalid_argument(m.name + ": an equation refers to the same coordinate twice");
    previous = r;
    slots[i] = p.dependent_entries() + static_cast<int>(p.known.size());
    if (r[0] == 0) {
      p.row.push_back(entries[i].row);
      ++p.column_start[r[1] + 1];
    } else if (r[0] == 1) {
      p.known.push_back(entries[i]);
    }
  }
  std::partial_sum(p.column_start.begin(), p.column_start.end(), p.column_start.begin());
  return {std::move(p), std::move(slots)};
}

}  // namespace desmo
