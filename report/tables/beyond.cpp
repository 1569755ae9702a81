// What settings and generated code gain over the paper's: formulations with settings beside the
// global reference, everything delivered and what a request asks for; threads apart.
#include <algorithm>
#include <set>

#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr std::string_view reference_id = "global_automatic_klu";

/// Something timed with the same delivery as others.
struct Timed {
  std::string id;
  Measured time;
  const std::optional<Verification>* verification;  // null: a request has none of its own
  std::optional<double> iterations;
};

struct Delivery {
  std::string delivered;
  std::vector<Timed> timed;
};

std::string without_settings(const std::string& id) { return id.substr(0, id.find('/')); }

/// Largest size at which a case was solved with settings; nothing where there is none.
std::optional<std::int64_t> size_with_settings(const Record& record, std::string_view case_name) {
  std::optional<std::int64_t> size;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && has_settings(key.id) && !is_beside_peers(record, key.id))
      size = std::max(size.value_or(0), key.coordinates);
  return size;
}

/// With settings, the same without, and the reference.
bool belongs(const std::string& id, const std::set<std::string>& bases) {
  return id == reference_id || bases.contains(without_settings(id));
}

std::vector<Delivery> deliveries(const Record& record, std::string_view case_name,
                                 std::int64_t size) {
  std::set<std::string> bases;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && key.coordinates == size && has_settings(key.id) &&
        !is_beside_peers(record, key.id))
      bases.insert(without_settings(key.id));
  std::vector<Delivery> all{{"everything", {}}};
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && key.coordinates == size && belongs(key.id, bases) &&
        !is_beside_peers(record, key.id))
      all.front().timed.push_back(
          {key.id, measured(candidate), &candidate.verification, candidate.iterations_per_step});
  std::set<std::string> requests;
  for (const Request& request : record.requests)
    if (request.candidate.case_name == case_name && request.candidate.coordinates == size &&
        has_settings(request.candidate.id) && requests.insert(request.name).second)
      all.push_back({request.title, {}});
  for (const Request& request : record.requests) {
    const auto delivery = std::ranges::find(all, request.title, &Delivery::delivered);
    if (request.candidate.case_name == case_name && request.candidate.coordinates == size &&
        delivery != all.end() && belongs(request.candidate.id, bases))
      delivery->timed.push_back(
          {request.candidate.id, measured(request), nullptr, request.iterations_per_step});
  }
  return all;
}

/// The fastest reference that has the same guess and tolerance.
const Timed* like_for_like(const Delivery& delivery, const std::string& id) {
  const Timed* best = nullptr;
  for (const Timed& one : delivery.timed)
    if (without_settings(one.id) == reference_id && one.time.seconds &&
        setting(one.id, "guess") == setting(id, "guess") &&
        setting(one.id, "tolerance") == setting(id, "tolerance") &&
        (!best || one.time.seconds->value < best->time.seconds->value))
      best = &one;
  return best;
}

const Timed* paper_reference(const Delivery& delivery) {
  const auto found = std::ranges::find(delivery.timed, reference_id, &Timed::id);
  return found == delivery.timed.end() ? nullptr : &*found;
}

Entry ratio(const Timed* reference, const Timed& one) {
  if (!reference) return note_entry(missing_mark);
  if (reference == &one) return {"1.00 reference", {"1.00", "", ""}, "reference"};
  const MeasuredSpeedUp ratio = measured_speed_up(reference->time, one.time);
  return ratio.speed_up ? ratio_entry(*ratio.speed_up) : note_entry(ratio.mark);
}

void add_rows(Table& table, const Record& record, Delivery& delivery) {
  std::ranges::stable_sort(delivery.timed, std::ranges::greater{}, [](const Timed& one) {
    return one.time.seconds ? one.time.seconds->value : 0;
  });
  const Timed* const paper = paper_reference(delivery);
  for (const Timed& one : delivery.timed) {
    std::optional<double> step, error;
    if (one.time.seconds)
      step = 1e6 * one.time.seconds->value / static_cast<double>(record.settings.instants);
    if (one.verification && *one.verification) error = (*one.verification)->position;
    table.rows.push_back({text_entry(delivery.delivered), text_entry(one.id),
                          seconds_entry(one.time), number_entry(step, 4), ratio(paper, one),
                          ratio(like_for_like(delivery, one.id), one),
                          number_entry(one.iterations, 3), number_entry(error, 2)});
  }
}

Table beyond_table(const Record& record, const std::string& case_name, std::int64_t size) {
  const TimeWords words = time_words(record);
  Table table{
      .name = "beyond_" + case_name,
      .title = "Beyond the paper: " + case_name + ", " + std::to_string(size) + " coordinates",
      .notes =
          {"Times: how many times as fast as " + std::string(reference_id) +
               " with the paper's settings, and, like for like, as the fastest of it with the same "
               "guess and tolerance, delivering the same in the same run; ratio of the " +
               words.times + " [its interval]; " + inconclusive_note() + ".",
           "lanes: parts of one type solved side by side, step by step. segments: segments of "
           "the motion, which has to be known in advance, solved side by side.",
           "CPU s: " + words.time +
               " ± half the range, first assembly, drivers, all steps and delivery."},
      .columns = {{"delivered", {}},
                  {"id", {}},
                  {"CPU s", {"seconds", "half_range", "repetitions"}},
                  {"µs/step", {"microseconds"}},
                  {"times the paper's settings", {"ratio", "low", "high"}},
                  {"times like for like", {"ratio", "low", "high"}},
                  {"iterations/step", {"iterations"}},
                  {"error q", {"error"}}},
      .rows = {}};
  define_time(table, record);
  for (Delivery& delivery : deliveries(record, case_name, size)) add_rows(table, record, delivery);
  return table;
}

}  // namespace

Section beyond(const Record& record) {
  Section section{.title = "Beyond the paper", .paragraphs = {}, .tables = {}};
  std::set<std::string> cases;
  for (const auto& [key, candidate] : record.candidates) cases.insert(key.case_name);
  for (const std::string& name : cases)
    if (const auto size = size_with_settings(record, name))
      section.tables.push_back(beyond_table(record, name, *size));
  for (Table& table : threads(record)) section.tables.push_back(std::move(table));
  return section;
}

}  // namespace desmo::report
