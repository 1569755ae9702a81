// Tables of all candidates, not only of those that the paper compares; of several threads by the
// wall clock; and of the phases of a step.
#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

#include "report/statistics/comparability.h"
#include "report/statistics/paper.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Returns the candidates of a case and size, the fastest first; those without a time come last, by
/// id. Leaves out candidates next to peers, which the table of peers shows.
std::vector<CandidateKey> ordered_keys(const Record& record, const CaseSize& place) {
  std::vector<CandidateKey> keys = candidates_at(
      record, place, [&](const std::string& id) { return !is_beside_peers(record, id); });
  std::ranges::stable_sort(keys, {}, [&](const CandidateKey& key) {
    const Measured time = measured(record, key);
    return time.seconds ? time.seconds->value : std::numeric_limits<double>::infinity();
  });
  return keys;
}

/// Returns the speed-up of a key relative to a reference, without its interval.
Entry plain_ratio(const Record& record, const std::optional<CandidateKey>& reference,
                  const CandidateKey& key) {
  if (key == reference) return reference_entry();
  const MeasuredSpeedUp ratio = measured_speed_up(record, reference, key);
  if (!ratio.speed_up) return note_entry(ratio.mark);
  return composed("{}", {ratio_text(*ratio.speed_up)},
                  ratio.speed_up->inconclusive() ? inconclusive_mark : "");
}

Table formulations_at(const Record& record, const CaseSize& place) {
  Table table = headed_table(
      "formulations_case",
      timed_words(record, {{"case", place.case_name}, {"coordinates", place.coordinates}}));
  const auto reference = papers_reference(record, place);
  for (const CandidateKey& key : ordered_keys(record, place)) {
    const Measurement& candidate = record.candidates.at(key);
    const Measured time = measured(candidate);
    std::vector<Entry> row{key.id,
                           seconds_entry(time, Spread::range),
                           instant_entry(record, time),
                           plain_ratio(record, reference, key),
                           plain_ratio(record, reference_like(record, key), key),
                           number_entry(candidate.iterations_per_step, 3)};
    add_errors(row, candidate);
    row.push_back(number_entry(candidate.setup_seconds, 2));
    row.push_back(remark(candidate));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace

// Tables are details, except for one of each case: that of the paper's largest size, or of the
// case's largest where that is missing.
Section every_formulation(const Record& record) {
  Section section = headed_section("formulations");
  for (const auto& [name, sizes] : recorded_sizes(record.candidates)) {
    const std::int64_t max_published = published_sizes().back(),
                       shown = sizes.contains(max_published) ? max_published : *sizes.rbegin();
    for (const std::int64_t size : sizes) {
      section.tables.push_back(formulations_at(record, {name, size}));
      if (size == shown) continue;
      section.tables.back().detail = true;
      section.tables.back().figure.clear();
    }
  }
  return section;
}

namespace {

/// Key by which rows are sorted: coordinates, request (request_of()), analysis, threads. The
/// analysis is the id without request, threads and clock.
using Place = std::tuple<std::int64_t, std::string, std::string, std::int64_t>;

/// Returns the sort key of a candidate's row. Reads the number of threads from the id, since a
/// failed candidate records none.
Place place_of(const CandidateKey& key) {
  const std::string_view threads = setting(key.id, "threads");
  std::string analysis = key.id;
  for (const char* part : {"request", "threads", "clock"})
    analysis = without_setting(std::move(analysis), part);
  return {key.coordinates, std::string(request_of(key.id)), std::move(analysis),
          threads.empty() ? 1 : std::stoll(std::string(threads))};
}

}  // namespace

Section threads(const Record& record) {
  Section section = headed_section("threads_section");
  const Measurements all = measurements_by(Clock::wall, record);
  std::map<std::string, std::string> delivered{{"", "everything"}};
  for (const MeasuredRequest& request : record.requests)
    delivered["/request:" + request.name] = request.title;
  std::map<std::string, std::map<Place, CandidateKey>> cases;
  for (const auto& [key, candidate] : all) cases[key.case_name][place_of(key)] = key;
  for (const auto& [name, places] : cases) {
    Table table = headed_table("threads", timed_words(record, {{"case", name}}));
    for (const auto& [place, key] : places) {
      const auto& [coordinates, request, analysis, threads] = place;
      const Measurement& candidate = *all.at(key);
      const Measured time = measured(candidate);
      const auto one = all.find(reference_of(key));
      table.rows.push_back({coordinates, delivered.at(request), analysis, threads,
                            seconds_entry(time), instant_entry(record, time),
                            one == all.end() ? note_entry(sentence("threads.alone"))
                            : one->first == key
                                ? reference_entry()
                                : ratio_entry(measured_speed_up(measured(*one->second), time)),
                            remark(candidate)});
    }
    section.tables.push_back(std::move(table));
  }
  return section;
}

namespace {

Entry phase_entry(double seconds, double total) {
  const double percent = total > 0 ? 100 * seconds / total : 0;
  return composed("{} ({} %)", {write_significant(seconds * 1e6, 3), write_fixed(percent, 0)});
}

}  // namespace

Table time_split(const Record& record) {
  Table table = headed_table("time_split");
  for (const char* phase : phases) table.columns.push_back({phase, {"microseconds", "percent"}});
  for (const auto& [key, profile] : record.profiles) {
    const bool failed = measured(record, key).mark == failed_mark;
    double total = 0;
    for (const double seconds : profile) total += seconds;
    std::vector<Entry> row{key.case_name, key.coordinates, key.id,
                           failed ? note_entry(failed_mark) : number_entry(1e6 * total, 4)};
    for (const double seconds : profile)
      row.push_back(failed ? note_entry(failed_mark) : phase_entry(seconds, total));
    table.rows.push_back(std::move(row));
  }
  return table;
}

}  // namespace desmo::report
