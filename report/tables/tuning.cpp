// What desmo tune promises: is it kept, and how far is its choice from the best there is?
#include <algorithm>

#include "report/statistics/selection.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr double as_good = 1.1;  // times the best's time

bool is_kept(const Promise& promise) { return promise.choice.error <= promise.allowed; }

/// How many times as long as the best.
SpeedUp excess(const Promise& promise) {
  return step_ratio(promise.choice.seconds_per_step, promise.best.seconds_per_step);
}

std::vector<Entry> row(const Promise& p) {
  return {text_entry(p.mechanism),
          text_entry(std::to_string(p.coordinates)),
          text_entry(write_shortest(p.allowed)),
          error_entry(p.promised),
          error_entry(p.choice.error),
          text_entry(is_kept(p) ? "kept" : "BROKEN"),
          text_entry(p.choice.id),
          step_time_entry(p.choice.seconds_per_step),
          p.best.id == p.choice.id ? Entry{"1.00 itself", {"1.00", "", ""}, "itself"}
                                   : ratio_entry(excess(p)),
          text_entry(p.best.id == p.choice.id ? "" : p.best.id)};
}

Table table_of(const Record& record) {
  Table table{
      .name = "tuning",
      .title = "What desmo tune chooses, and what that is worth",
      .notes =
          {"Error: of position, the largest. Promised: by the search; measured: afterwards, at "
           "every instant of the motion. Times the best's: the choice's µs/step over that of the "
           "fastest configuration there is, of all formulations with all settings, that holds "
           "half of the error, as the search asks of its own choice; both timed in turn.",
           step_time_note()},
      .columns = {{"mechanism", {}},
                  {"coordinates", {}},
                  {"error at most", {}},
                  {"promised", {"error"}},
                  {"measured", {"error"}},
                  {"promise", {}},
                  {"choice", {}},
                  {"µs/step", {"microseconds", "again"}},
                  {"times the best's", {"ratio", "low", "high"}},
                  {"best", {}}},
      .rows = {}};
  for (const Promise& promise : record.tuning) table.rows.push_back(row(promise));
  return table;
}

std::string of_all(std::size_t count, std::size_t all) {
  return std::to_string(count) + " of " + std::to_string(all);
}

}  // namespace

Section tuning(const Record& record) {
  const std::vector<Promise>& all = record.tuning;
  const auto kept = static_cast<std::size_t>(std::ranges::count_if(all, is_kept));
  const auto good = static_cast<std::size_t>(
      std::ranges::count_if(all, [](const Promise& p) { return excess(p).value <= as_good; }));
  const Promise& worst =
      *std::ranges::max_element(all, {}, [](const Promise& p) { return excess(p).value; });
  const double largest = excess(worst).value;
  return {"What desmo tune promises",
          {"The error asked for is held in " + of_all(kept, all.size()) +
           " searches. The choice takes at most " + write(as_good, ratio_digits(as_good)) +
           " times as long as the best there is in " + of_all(good, all.size()) + "; the most is " +
           write(largest, ratio_digits(largest)) + ", of " + worst.mechanism + " at " +
           write_shortest(worst.allowed) + "."},
          {table_of(record)}};
}

}  // namespace desmo::report
