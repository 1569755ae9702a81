// The table of what checking a run costs.
#include <numeric>

#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Additional time of a checked run, compared with a bare one.
struct Price {
  // Additional time of a step [µs], the same [% of a bare step], and that of the start [ms].
  std::optional<double> step, share, start;
};

/// Tells whether a time has too few repetitions for a difference of two times.
bool is_of_few(const Measured& time) { return time.seconds && !time.seconds->has_interval(); }

/// Returns the price of a checked run. Checks are prepared in the first timing window, so the price
/// of a step is taken from all other windows. The price of the start is what checking adds to the
/// first window, less what it adds to another one. Returns an empty price unless both times have as
/// many windows, two or more.
Price price_of(const Record& record, const Measured& bare, const Measured& checked) {
  if (!bare.seconds || !checked.seconds) return {};
  const std::vector<double>&without = bare.seconds->windows, &with = checked.seconds->windows;
  if (with.size() < 2 || without.size() != with.size()) return {};
  const double windows = static_cast<double>(with.size() - 1),
               before = std::accumulate(without.begin() + 1, without.end(), 0.0) / windows,
               after = std::accumulate(with.begin() + 1, with.end(), 0.0) / windows;
  const double steps = static_cast<double>(record.settings.instants) / (windows + 1);
  return {1e6 * (after - before) / steps, 100 * (after / before - 1),
          1e3 * (with[0] - without[0] - (after - before))};
}

}  // namespace

Section checks(const Record& record) {
  const std::int64_t windows = record.settings.windows.value_or(1);
  Table table = headed_table("checks", timed_words(record, {{"windows", windows}}));
  for (const auto& [key, candidate] : record.candidates) {
    const std::string check(setting(key.id, "check"));
    if (check.empty()) continue;
    const CandidateKey without{key, without_setting(key.id, "check")};
    const Measured bare = measured(record, without), checked = measured(candidate);
    if (is_of_few(bare) || is_of_few(checked)) continue;
    const Price price = price_of(record, bare, checked);
    table.rows.push_back({key.case_name, key.coordinates, without.id, check,
                          instant_entry(record, bare), instant_entry(record, checked),
                          number_entry(price.step, 2), number_entry(price.share, 2),
                          number_entry(price.start, 2), remark(candidate)});
  }
  return headed_section("checks_section", {}, {std::move(table)});
}

}  // namespace desmo::report
