// What settings and generated code gain over the paper's: formulations with settings next to the
// global reference, everything delivered and what a request asks for; threads apart.
#include <algorithm>
#include <set>

#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// Something timed with the same delivery as others.
struct Timed {
  std::string id;
  const Candidate* candidate;
  Measured time = measured(*candidate);
};

struct Delivery {
  std::string delivered;
  std::vector<Timed> timed;
};

std::string without_settings(const std::string& id) { return id.substr(0, id.find('/')); }

bool is_beyond(const Record& record, const CandidateKey& key) {
  return has_settings(key.id) && !is_beside_peers(record, key.id);
}

/// Returns formulations with settings, the same without, and the reference; by what is delivered.
std::vector<Delivery> deliveries(const Record& record, const CandidateKey& place) {
  const auto is_here = [&](const CandidateKey& key) {
    return key.case_name == place.case_name && key.coordinates == place.coordinates;
  };
  std::set<std::string> bases{std::string(usual_reference)};
  for (const auto& [key, candidate] : record.candidates)
    if (is_here(key) && is_beyond(record, key)) bases.insert(without_settings(key.id));
  std::vector<Delivery> all{{"everything", {}}};
  for (const auto& [key, candidate] : record.candidates)
    if (is_here(key) && bases.contains(without_settings(key.id)) &&
        !is_beside_peers(record, key.id))
      all.front().timed.push_back({key.id, &candidate});
  for (const Request& request : record.requests)
    if (is_here(request.key) && has_settings(request.key.id) &&
        !std::ranges::count(all, request.title, &Delivery::delivered))
      all.push_back({request.title, {}});
  for (const Request& request : record.requests) {
    const auto delivery = std::ranges::find(all, request.title, &Delivery::delivered);
    if (is_here(request.key) && delivery != all.end() &&
        bases.contains(without_settings(request.key.id)))
      delivery->timed.push_back({request.key.id, &request.solved});
  }
  return all;
}

/// Returns the fastest reference that has the same guess and tolerance; null where there is none.
const Timed* like_for_like(const Delivery& delivery, const std::string& id) {
  const Timed* best = nullptr;
  for (const Timed& one : delivery.timed)
    if (without_settings(one.id) == usual_reference && one.time.seconds &&
        setting(one.id, "guess") == setting(id, "guess") &&
        setting(one.id, "tolerance") == setting(id, "tolerance") &&
        (!best || one.time.seconds->value < best->time.seconds->value))
      best = &one;
  return best;
}

Entry ratio(const Timed* reference, const Timed& one) {
  if (!reference) return note_entry(missing_mark);
  if (reference == &one) return reference_entry();
  return ratio_entry(measured_speed_up(reference->time, one.time));
}

void add_delivery(Table& table, const Record& record, Delivery delivery) {
  std::ranges::stable_sort(delivery.timed, std::ranges::greater{}, [](const Timed& one) {
    return one.time.seconds ? one.time.seconds->value : 0;
  });
  const auto paper = std::ranges::find(delivery.timed, usual_reference, &Timed::id);
  for (const Timed& one : delivery.timed) {
    const auto& checked = one.candidate->verification;
    table.rows.push_back(
        {delivery.delivered, one.id, seconds_entry(one.time), instant_entry(record, one.time),
         ratio(paper == delivery.timed.end() ? nullptr : &*paper, one),
         ratio(like_for_like(delivery, one.id), one),
         number_entry(one.candidate->iterations_per_step, 3),
         number_entry(checked ? std::optional(checked->position) : std::nullopt, 2)});
  }
}

}  // namespace

Section beyond(const Record& record) {
  Section section = headed_section("beyond");
  std::map<std::string, CandidateKey> places;  // the largest size with settings of each case
  for (const auto& [key, candidate] : record.candidates)
    if (is_beyond(record, key)) places[key.case_name] = key;
  for (const auto& [name, place] : places) {
    Table table = headed_table(
        "beyond_case",
        {{"case", name}, {"coordinates", place.coordinates}, {"time", time_word(record)}});
    define_time(table, record);
    for (Delivery& delivery : deliveries(record, place))
      add_delivery(table, record, std::move(delivery));
    section.tables.push_back(std::move(table));
  }
  std::ranges::move(threads(record), std::back_inserter(section.tables));
  return section;
}

}  // namespace desmo::report
