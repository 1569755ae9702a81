// What several threads gain: the wall clock's times, and ratios of them over one thread's.
#include <map>
#include <tuple>

#include "report/statistics/comparability.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// What stands in a row, in the order of rows: the analysis is the id without threads and clock.
using Place = std::tuple<std::int64_t, std::string, std::string, std::int64_t>;

/// Where a failure recorded no number of threads, the id names it.
Place place_of(const CandidateKey& key) {
  const std::string_view threads = setting(key.id, "threads"), request = setting(key.id, "request");
  std::string analysis = key.id;
  for (const char* name : {"threads", "clock", "request"})
    analysis = without_setting(analysis, name);
  return {key.coordinates, std::string(request.empty() ? "everything" : request), analysis,
          threads.empty() ? 1 : std::stoll(std::string(threads))};
}

}  // namespace

Section threads(const Record& record) {
  Section section = headed_section("threads_section");
  const std::map<CandidateKey, Timing> all = timings(record, Clock::wall);
  std::map<std::string, std::map<Place, CandidateKey>> cases;
  for (const auto& [key, timing] : all) cases[key.case_name][place_of(key)] = key;
  for (const auto& [name, places] : cases) {
    Table table = headed_table("threads", {{"case", name}});
    for (const auto& [place, key] : places) {
      const auto& [coordinates, delivered, analysis, threads] = place;
      const Timing& timing = all.at(key);
      const auto one = all.find(reference_of(key));
      table.rows.push_back({coordinates, delivered, analysis, digits_entry(std::to_string(threads)),
                            seconds_entry(timing.time), instant_entry(record, timing.time),
                            one == all.end() ? note_entry(sentence("threads.alone"))
                            : one->first == key
                                ? reference_entry()
                                : ratio_entry(measured_speed_up(one->second.time, timing.time)),
                            timing.remark});
    }
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace desmo::report
