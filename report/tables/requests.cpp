// What it costs to solve only what is asked.
#include <map>
#include <set>

#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

Entry unknowns_entry(std::int64_t solved, std::int64_t all) {
  const std::string some = std::to_string(solved), whole = std::to_string(all);
  return {some + " of " + whole, {some, whole}, {}};
}

std::vector<Entry> request_row(const Record& record, const Request& request) {
  const Measured time = measured(request.solved);
  return {request.title,
          request.level,
          request.key.id,
          unknowns_entry(request.unknowns, request.all_unknowns),
          seconds_entry(time),
          speed_up_entry(measured_speed_up(measured(record, request.key), time)),
          number_entry(time.seconds ? request.solved.iterations_per_step : std::nullopt, 3),
          number_entry(request.difference, 2),
          remark(request.solved)};
}

/// The row of what solves everything with the formulation of a request.
std::vector<Entry> everything_row(const Record& record, const Request& request) {
  const Measured time = measured(record, request.key);
  const auto whole = record.candidates.find(request.key);
  const bool found = whole != record.candidates.end();
  return {"everything",
          "acceleration",
          request.key.id,
          unknowns_entry(request.all_unknowns, request.all_unknowns),
          seconds_entry(time),
          time.seconds ? reference_entry() : note_entry(time.mark),
          number_entry(time.seconds ? whole->second.iterations_per_step : std::nullopt, 3),
          note_entry(missing_mark),
          found ? remark(whole->second) : ""};
}

}  // namespace

Section requests(const Record& record) {
  Section section = headed_section("requests");
  std::map<std::pair<std::string, std::int64_t>, std::vector<const Request*>> places;
  for (const Request& request : record.requests)
    places[{request.key.case_name, request.key.coordinates}].push_back(&request);
  const auto& allowed = record.settings.allowed;
  for (const auto& [place, asked] : places) {
    Table table = headed_table(
        "requests_case",
        {{"case", place.first},
         {"coordinates", place.second},
         {"time", time_word(record)},
         {"allowed", allowed && allowed->request ? write_shortest(*allowed->request) : "any"}});
    define_time(table, record);
    std::set<std::string> ids;
    for (const Request* request : asked)
      if (ids.insert(request->key.id).second)
        table.rows.push_back(everything_row(record, *request));
    for (const Request* request : asked) table.rows.push_back(request_row(record, *request));
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace desmo::report
