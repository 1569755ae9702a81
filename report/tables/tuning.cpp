// What desmo tune promises: is it kept, and how far is its choice from the best there is?
#include <algorithm>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr double as_good = 1.1;  // times the best's time

bool is_kept(const Promise& promise) { return promise.choice.error <= promise.allowed; }

/// How many times as long as the best.
SpeedUp times_the_best(const Promise& promise) {
  return step_ratio(promise.choice.seconds_per_step, promise.best.seconds_per_step);
}

Table tuning_table(const Record& record) {
  Table table = headed_table("tuning");
  for (const Promise& p : record.tuning) {
    const bool itself = p.best.id == p.choice.id;
    table.rows.push_back(
        {p.mechanism, p.coordinates, write_shortest(p.allowed), error_entry(p.promised),
         error_entry(p.choice.error), is_kept(p) ? "kept" : "BROKEN", p.choice.id,
         step_time_entry(p.choice.seconds_per_step),
         itself ? Entry{"1.00 itself", {"1.00"}, "itself"} : ratio_entry(times_the_best(p)),
         itself ? "" : p.best.id});
  }
  return table;
}

}  // namespace

std::vector<Section> tuning_sections(const Record& record) {
  const std::vector<Promise>& all = record.tuning;
  const auto excess = [](const Promise& p) { return times_the_best(p).value; };
  const Promise& worst = *std::ranges::max_element(all, {}, excess);
  Section front = headed_section("tuning_front"),
          section = headed_section(
              "tuning_section",
              {{"all", all.size()},
               {"kept", std::ranges::count_if(all, is_kept)},
               {"good",
                std::ranges::count_if(all, [&](const Promise&p) { return excess(p) <= as_good; })},
               {"most", write(excess(worst), ratio_digits(excess(worst)))},
               {"mechanism", worst.mechanism},
               {"error", write_shortest(worst.allowed)}});
  section.tables = {tuning_table(record)};
  front.tables = {excerpt(section.tables.front(), headed_table("tuning_in_short"))};
  return {front, section};
}

}  // namespace desmo::report
