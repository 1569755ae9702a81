#include "formulations/verification/run/row_tally.h"

#include <algorithm>

#include "formulations/verification/run/relative_radius.h"

namespace desmo {

void RowTally::take(CheckedInstant& row, CheckedSummary& summary) {
  // Comes first, since take_radius() may replace the flag.
  row.for_each_flag([&](const RowFlag& flag) { take_flag(flag, summary); });
  take_radius(row);
  if (!row.flag) return;
  ++summary.flagged;
  if (!summary.first_flag) summary.first_flag = row.flag;
}

/// Includes a row in the scales and the largest radii, unless it is unproven. If its radii leave no
/// digit, flags it instead of including them.
void RowTally::take_radius(CheckedInstant& row) {
  if (row.flag && row.flag->kind == RowFlag::Kind::unproven) {
    row.relative_radius = {INFINITY, INFINITY, INFINITY};
    return;
  }
  scales_.take(row.instant);
  const RelativeRadius radius = relative_radius(m_, row.radius, scales_.current());
  row.relative_radius = radius.largest;
  if (radius.proves_no_digit()) {
    worsen(row.flag,
           {.time = row.instant.time, .group = radius.group, .failure = ProofFailure::singular});
    return;
  }
  for (const Level level : all_levels) {
    length_[level] = std::max(length_[level], radius.length[level]);
    rotation_[level] = std::max(rotation_[level], radius.rotation[level]);
  }
  if (row.is_on_point) row.relative_radius = {INFINITY, INFINITY, INFINITY};
}

void RowTally::take_flag(const RowFlag& flag, CheckedSummary& summary) {
  if (flag.is_of_change_point()) {
    const auto [last, is_new] = last_point_.try_emplace(flag.group, flag.after);
    summary.crossings += is_new || last->second != flag.after;
    last->second = flag.after;
    if (!summary.first_crossing) summary.first_crossing = flag;
  }
  if (flag.misfit && (!summary.misfit || flag.misfit->relative > summary.misfit->relative))
    summary.misfit = flag.misfit;
}

void RowTally::finish(CheckedSummary& summary) const {
  constexpr double above = 1 + 0x1p-48;  // covers the few roundings of a ratio
  const auto share = [](double radius, double scale) { return scale > 0 ? radius / scale : 0; };
  summary.scales = scales_.current();
  for (const Level l : all_levels)
    summary.radius[l] = above * std::max(share(length_[l], summary.scales.length[l]),
                                         share(rotation_[l], summary.scales.rotation[l]));
}

}  // namespace desmo
