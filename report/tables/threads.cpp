// What several threads gain: the wall clock's times, and ratios of them over one thread's.
#include <algorithm>
#include <set>
#include <tuple>

#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Something timed by the wall clock.
struct WallTimed {
  std::int64_t coordinates;
  std::string delivered, analysis;  ///< which analysis: the id without threads and clock
  std::int64_t threads;
  Measured time;
  std::string remark;
};

/// Where a failure recorded no number of threads, the id names it.
std::int64_t threads_of(const std::string& id) {
  const std::string_view count = setting(id, "threads");
  return count.empty() ? 1 : std::stoll(std::string(count));
}

template <class Solved>
WallTimed timed_of(const CandidateKey& key, const std::string& delivered, const Solved& solved) {
  return {key.coordinates,
          delivered,
          without_setting(without_setting(key.id, "threads"), "clock"),
          threads_of(key.id),
          measured(solved),
          remark(solved.status, solved.message)};
}

std::vector<WallTimed> timed_by_wall(const Record& record, const std::string& case_name) {
  std::vector<WallTimed> all;
  for (const auto& [key, candidate] : record.wall_candidates)
    if (key.case_name == case_name) all.push_back(timed_of(key, "everything", candidate));
  for (const Request& request : record.wall_requests)
    if (request.candidate.case_name == case_name)
      all.push_back(timed_of(request.candidate, request.title, request));
  std::ranges::stable_sort(all, {}, [](const WallTimed& one) {
    return std::tuple(one.coordinates, one.delivered != "everything", one.delivered, one.analysis,
                      one.threads);
  });
  return all;
}

Entry over_one_thread(const std::vector<WallTimed>& all, const WallTimed& several) {
  const auto one = std::ranges::find_if(all, [&](const WallTimed& other) {
    return other.threads == 1 && other.coordinates == several.coordinates &&
           other.delivered == several.delivered && other.analysis == several.analysis;
  });
  if (one == all.end()) return note_entry("one thread not measured");
  if (&*one == &several) return {"1.00 reference", {"1.00", "", ""}, "reference"};
  const MeasuredSpeedUp ratio = measured_speed_up(one->time, several.time);
  return ratio.speed_up ? ratio_entry(*ratio.speed_up) : note_entry(ratio.mark);
}

Table threads_of_case(const Record& record, const std::string& case_name) {
  Table table{
      .name = "threads_" + case_name,
      .title = "Several threads, by the wall clock: " + case_name,
      .notes = {"Wall s: seconds that passed, the least repetition ± half the range. Times: "
                "how many times as fast as the same analysis on one thread by the same "
                "clock [without the best repetition of either side]; " +
                inconclusive_note() + ". No time here compares with CPU time."},
      .columns = {{"coordinates", {}},
                  {"delivered", {}},
                  {"id", {}},
                  {"threads", {"threads"}},
                  {"wall s", {"seconds", "half_range", "repetitions"}},
                  {"µs/step", {"microseconds"}},
                  {"times one thread", {"ratio", "low", "high"}},
                  {"remark", {}}},
      .rows = {}};
  const std::vector<WallTimed> all = timed_by_wall(record, case_name);
  for (const WallTimed& one : all) {
    std::optional<double> step;
    if (one.time.seconds)
      step = 1e6 * one.time.seconds->value / static_cast<double>(record.settings.instants);
    table.rows.push_back({text_entry(std::to_string(one.coordinates)), text_entry(one.delivered),
                          text_entry(one.analysis),
                          count_entry(static_cast<std::size_t>(one.threads)),
                          seconds_entry(one.time), number_entry(step, 4), over_one_thread(all, one),
                          text_entry(one.remark)});
  }
  return table;
}

}  // namespace

std::vector<Table> threads(const Record& record) {
  std::set<std::string> cases;
  for (const auto& [key, candidate] : record.wall_candidates) cases.insert(key.case_name);
  for (const Request& request : record.wall_requests) cases.insert(request.candidate.case_name);
  std::vector<Table> tables;
  for (const std::string& name : cases) tables.push_back(threads_of_case(record, name));
  return tables;
}

}  // namespace desmo::report
