// The table of what it costs to solve only what a request needs.
#include <map>
#include <set>

#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

Entry unknowns_entry(std::int64_t solved, std::int64_t all) {
  return composed("{} of {}", {std::to_string(solved), std::to_string(all)});
}

/// Returns the row of a request. If `request` is null, returns the row of the candidate that solves
/// everything by the formulation of `like`; else `like` is the request itself.
std::vector<Entry> row_of(const Record& record, const MeasuredRequest& like,
                          const MeasuredRequest* request) {
  const auto whole = record.candidates.find(like.key);
  const Measurement* solved = whole == record.candidates.end() ? nullptr : &whole->second;
  if (request) solved = request;
  const Measured all = measured(record, like.key), time = request ? measured(*solved) : all;
  return {request ? request->title : "everything",
          request ? request->level : "acceleration",
          like.key.id,
          unknowns_entry(request ? request->unknowns : like.all_unknowns, like.all_unknowns),
          seconds_entry(time),
          request        ? ratio_entry(measured_speed_up(all, time), true)
          : time.seconds ? reference_entry()
                         : note_entry(time.mark),
          number_entry(time.seconds ? solved->iterations_per_step : std::nullopt, 3),
          solved ? remark(*solved) : ""};
}

/// Returns a sentence on the least and the largest speed-up of a request relative to everything,
/// and on the request with the largest.
std::string found(const Record& record, const std::vector<const MeasuredRequest*>& asked) {
  std::optional<SpeedUp> least, most;
  const MeasuredRequest* best = nullptr;
  for (const MeasuredRequest* request : asked) {
    const auto ratio =
        measured_speed_up(measured(record, request->key), measured(*request)).speed_up;
    if (!ratio) continue;
    if (!least || ratio->value < least->value) least = ratio;
    if (!most || ratio->value > most->value) most = ratio, best = request;
  }
  if (!best) return sentence("requests.none");
  const std::string from = ratio_text(*least), to = ratio_text(*most);
  return sentence("requests.found", {{"case", best->key.case_name},
                                     {"coordinates", best->key.coordinates},
                                     {"times", from == to ? to : from + " to " + to},
                                     {"request", best->title},
                                     {"solved", best->unknowns},
                                     {"all", best->all_unknowns}});
}

}  // namespace

Section requests(const Record& record) {
  Section section = headed_section("requests");
  std::map<CaseSize, std::vector<const MeasuredRequest*>> places;
  for (const MeasuredRequest& request : record.requests)
    if (!is_by_wall(request.key.id)) places[request.key].push_back(&request);
  if (!places.empty()) section.paragraphs = {found(record, places.rbegin()->second)};
  for (const auto& [place, asked] : places) {
    Table table = headed_table(
        "requests_case",
        timed_words(record, {{"case", place.case_name}, {"coordinates", place.coordinates}}));
    std::set<std::string> ids;
    for (const MeasuredRequest* request : asked)
      if (ids.insert(request->key.id).second)
        table.rows.push_back(row_of(record, *request, nullptr));
    for (const MeasuredRequest* request : asked)
      table.rows.push_back(row_of(record, *request, request));
    section.tables.push_back(std::move(table));
  }
  return section;
}

}  // namespace desmo::report
