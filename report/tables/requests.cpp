// What it costs to solve only what is asked.
#include <algorithm>
#include <set>

#include "report/statistics/measurements.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

using Place = std::pair<std::string, std::int64_t>;  // case and size

Place place_of(const Request& request) {
  return {request.candidate.case_name, request.candidate.coordinates};
}

Entry unknowns_entry(std::int64_t solved, std::int64_t all) {
  const std::string some = std::to_string(solved), whole = std::to_string(all);
  return {some + " of " + whole, {some, whole}, {}};
}

std::vector<Entry> everything_row(const Record& record, const Request& request) {
  const Measured time = measured(record, request.candidate);
  const auto candidate = record.candidates.find(request.candidate);
  const bool found = candidate != record.candidates.end();
  Entry ratio = note_entry(time.mark);
  if (time.seconds) ratio = {"1.00 reference", {"1.00", "", "", ""}, "reference"};
  return {text_entry("everything"),
          text_entry("acceleration"),
          text_entry(request.candidate.id),
          unknowns_entry(request.all_unknowns, request.all_unknowns),
          seconds_entry(time),
          std::move(ratio),
          number_entry(time.seconds ? candidate->second.iterations_per_step : std::nullopt, 3),
          note_entry(missing_mark),
          text_entry(found ? remark(candidate->second.status, candidate->second.message) : "")};
}

std::vector<Entry> request_row(const Record& record, const Request& request) {
  const Measured time = measured(request);
  const bool ok = time.seconds.has_value();
  return {text_entry(request.title),
          text_entry(request.level),
          text_entry(request.candidate.id),
          unknowns_entry(request.unknowns, request.all_unknowns),
          seconds_entry(time),
          speed_up_entry(measured_speed_up(measured(record, request.candidate), time)),
          number_entry(ok ? request.iterations_per_step : std::nullopt, 3),
          number_entry(request.difference, 2),
          text_entry(remark(request.status, request.message))};
}

// Of the requests alone: candidates may have been repeated more or less often.
std::string repetitions_at(const Record& record, const Place& place) {
  std::size_t least = 0, largest = 0;
  for (const Request& request : record.requests) {
    if (place_of(request) != place || request.status != Status::ok) continue;
    const std::size_t count = request.time.seconds.size();
    least = least == 0 ? count : std::min(least, count);
    largest = std::max(largest, count);
  }
  const std::string text = std::to_string(largest);
  return (least == largest ? text : std::to_string(least) + " to " + text) +
         (largest == 1 ? " repetition" : " repetitions");
}

std::string allowed_difference(const Record& record) {
  const auto& allowed = record.settings.allowed;
  if (!allowed || !allowed->request) return "";
  return " (" + write_shortest(*allowed->request) + " is allowed)";
}

Table request_table(const Record& record, const Place& place) {
  const auto& [case_name, coordinates] = place;
  const std::string size = std::to_string(coordinates);
  const TimeWords words = time_words(record);
  Table table{
      .name = "requests_" + case_name + "_" + size,
      .title = "What a request costs: " + case_name + ", " + size + " coordinates",
      .notes =
          {"Solved: the irreducible blocks of equations upstream of what is asked, each as far as "
           "anything asks of it; delivered: what is asked. CPU s: " +
               words.time + " ± half the range of " + repetitions_at(record, place) + ".",
           "Times cheaper: everything over the request with the same formulation in the same run, "
           "ratio of the " +
               words.times + " [its interval] (CPU time saved); " + inconclusive_note() + ".",
           "Both stop at the tolerance for what they solve, so that a request may need fewer "
           "iterations. Difference: largest of what is asked, over the whole motion, from the "
           "solution of the whole mechanism with the same formulation, both converged as far as "
           "double precision goes" +
               allowed_difference(record) + "."},
      .columns = {{"request", {}},
                  {"level", {}},
                  {"id", {}},
                  {"unknowns", {"solved", "all"}},
                  {"CPU s", {"seconds", "half_range", "repetitions"}},
                  {"times cheaper", {"speed_up", "low", "high", "percent"}},
                  {"iterations/step", {"iterations"}},
                  {"difference", {"difference"}},
                  {"remark", {}}},
      .rows = {}};
  define_time(table, record);
  std::set<std::string> ids;
  for (const Request& request : record.requests)
    if (place_of(request) == place && ids.insert(request.candidate.id).second)
      table.rows.push_back(everything_row(record, request));
  for (const Request& request : record.requests)
    if (place_of(request) == place) table.rows.push_back(request_row(record, request));
  return table;
}

}  // namespace

Section requests(const Record& record) {
  Section section{.title = "What a request costs", .paragraphs = {}, .tables = {}};
  std::set<Place> places;
  for (const Request& request : record.requests) places.insert(place_of(request));
  for (const Place& place : places) section.tables.push_back(request_table(record, place));
  return section;
}

}  // namespace desmo::report
