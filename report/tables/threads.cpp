// What several threads gain: the wall clock's times, and ratios of them over one thread's.
#include <algorithm>
#include <tuple>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// Something timed by the wall clock.
struct WallTimed {
  std::int64_t coordinates;
  std::string delivered, analysis;  ///< which analysis: the id without threads and clock
  std::int64_t threads;
  Measured time;
  std::string remark;

  auto place() const {
    return std::tuple(coordinates, delivered != "everything", delivered, analysis);
  }
};

/// Where a failure recorded no number of threads, the id names it.
WallTimed timed_by_wall(const CandidateKey& key, const std::string& delivered,
                        const Candidate& candidate) {
  const std::string_view count = setting(key.id, "threads");
  return {key.coordinates,
          delivered,
          without_setting(without_setting(key.id, "threads"), "clock"),
          count.empty() ? 1 : std::stoll(std::string(count)),
          measured(candidate),
          remark(candidate)};
}

Entry over_one_thread(const std::vector<WallTimed>& all, const WallTimed& several) {
  const auto one = std::ranges::find_if(all, [&](const WallTimed& other) {
    return other.threads == 1 && other.place() == several.place();
  });
  if (one == all.end()) return note_entry(sentence("threads.alone"));
  if (&*one == &several) return reference_entry();
  return ratio_entry(measured_speed_up(one->time, several.time));
}

}  // namespace

Section threads(const Record& record) {
  Section section = headed_section("threads_section");
  std::map<std::string, std::vector<WallTimed>> cases;
  for (const auto& [key, candidate] : record.wall_candidates)
    cases[key.case_name].push_back(timed_by_wall(key, "everything", candidate));
  for (const Request& request : record.wall_requests)
    cases[request.key.case_name].push_back(
        timed_by_wall(request.key, request.title, request.solved));
  for (auto& [name, all] : cases) {
    std::ranges::stable_sort(
        all, {}, [](const WallTimed& one) { return std::pair(one.place(), one.threads); });
    Table table = headed_table("threads", {{"case", name}});
    for (const WallTimed& one : all)
      table.rows.push_back({one.coordinates, one.delivered, one.analysis,
                            count_entry(static_cast<std::size_t>(one.threads)),
                            seconds_entry(one.time), instant_entry(record, one.time),
                            over_one_thread(all, one), one.remark});
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace desmo::report
