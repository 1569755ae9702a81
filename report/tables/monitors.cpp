// What it costs to monitor a run.
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::string_view monitored_suffix = "/monitored";

/// What a monitored run takes more than a bare one.
struct Price {
  std::optional<double> step, share, start;  // µs, of the bare step, ms
};

Price price_of(const Record& record, const Measured& bare, const Measured& monitored) {
  Price price;
  if (!bare.seconds || !monitored.seconds) return price;
  const SampleSummary &without = *bare.seconds, &with = *monitored.seconds;
  const double more = with.value - without.value;
  price.step = 1e6 * more / static_cast<double>(record.settings.instants);
  price.share = 100 * more / without.value;
  if (!with.windows.empty() && without.windows.size() == with.windows.size())
    price.start = 1e3 * (with.windows[0] - without.windows[0] -
                         more / static_cast<double>(with.windows.size()));
  return price;
}

}  // namespace

Section monitors(const Record& record) {
  Section section = headed_section("monitors_section");
  Table table = headed_table("monitors");
  for (const auto& [key, candidate] : record.candidates) {
    if (!key.id.ends_with(monitored_suffix)) continue;
    CandidateKey without = key;
    without.id.resize(key.id.size() - monitored_suffix.size());
    const Measured bare = measured(record, without), monitored = measured(candidate);
    const Price price = price_of(record, bare, monitored);
    table.rows.push_back({key.case_name, std::to_string(key.coordinates), without.id,
                          instant_entry(record, bare), instant_entry(record, monitored),
                          number_entry(price.step, 2), number_entry(price.share, 2),
                          number_entry(price.start, 2), remark(candidate)});
  }
  if (!table.rows.empty()) section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
