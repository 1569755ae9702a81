// All that was recorded, not only what the paper compares.
#include <algorithm>
#include <limits>

#include "report/statistics/measurements.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/tables/time_words.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

// What stands beside peers is shown there. Fastest first; what has no time comes last, by
// id.
std::vector<CandidateKey> ordered_keys(const Record& record, std::string_view case_name,
                                       std::int64_t coordinates) {
  std::vector<std::pair<double, CandidateKey>> found;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && key.coordinates == coordinates &&
        !is_beside_peers(record, key.id)) {
      const Measured time = measured(record, key);
      found.emplace_back(
          time.seconds ? time.seconds->value : std::numeric_limits<double>::infinity(), key);
    }
  std::sort(found.begin(), found.end());
  std::vector<CandidateKey> keys;
  for (auto& [seconds, key] : found) keys.push_back(std::move(key));
  return keys;
}

bool is_reference(const std::string& id) {
  return id == reference_of_one_block ||
         std::ranges::any_of(sparse_families, [&](std::string_view family) {
           return id == "global_automatic_" + std::string(family);
         });
}

std::optional<CandidateKey> fastest_reference(const Record& record,
                                              const std::vector<CandidateKey>& keys) {
  for (const CandidateKey& key : keys)
    if (is_reference(key.id) && measured(record, key).seconds) return key;
  return std::nullopt;
}

Entry range_entry(const Measured& time) {
  if (!time.seconds) return note_entry(time.mark);
  const DigitStyle style = significant_digits(time.seconds->value, 4);
  const std::string value = write(time.seconds->value, style),
                    least = write(time.seconds->least, style),
                    largest = write(time.seconds->largest, style),
                    count = std::to_string(time.seconds->count);
  if (time.seconds->count < 2) return {value + " (one run)", {value, "", "", count}, "one run"};
  return {value + " (" + least + " – " + largest + ")", {value, least, largest, count}, {}};
}

Entry ratio_entry(const Record& record, const std::optional<CandidateKey>& reference,
                  const CandidateKey& key) {
  if (!reference) return note_entry(missing_mark);
  const MeasuredSpeedUp ratio = measured_speed_up(record, *reference, key);
  if (!ratio.speed_up) return note_entry(ratio.mark);
  const std::string digits = write(ratio.speed_up->value, ratio_digits(ratio.speed_up->value));
  Entry entry{digits, {digits}, {}};
  if (key == *reference)
    add_note(entry, "reference");
  else if (ratio.speed_up->inconclusive())
    add_note(entry, inconclusive_mark);
  return entry;
}

/// "klu: 15 of 16 to 39 unknowns; eigen: 5 of 4 unknowns": by how many parts.
std::string solvers_text(const std::vector<Solver>& solvers) {
  std::string text;
  for (const auto& [algebra, parts, unknowns] : solvers)
    text += (text.empty() ? "" : "; ") + algebra + ": " + std::to_string(parts) + " of " +
            (unknowns[0] < unknowns[1] ? std::to_string(unknowns[0]) + " to " : "") +
            std::to_string(unknowns[1]) + " unknowns";
  return text;
}

std::string failure(const CandidateKey& key, const std::string& request, const std::string& why) {
  return std::string(failed_mark) + ": " + name_of(key) + request + ": " + why;
}

}  // namespace

Table every_formulation(const Record& record, std::string_view case_name,
                        std::int64_t coordinates) {
  const std::string place = std::string(case_name) + ", " + std::to_string(coordinates);
  const TimeWords words = time_words(record);
  Table table{
      .name = "formulations_" + std::string(case_name) + "_" + std::to_string(coordinates),
      .title = "Every formulation: " + place + " coordinates, fastest first",
      .notes = {"CPU seconds: " + words.time + " (smallest – largest) of " + repetitions(record) +
                "; speed-up: over the fastest global_automatic_<sparse>, ratio of " + words.times +
                "; " + inconclusive_note() +
                "; errors: largest difference from the quadruple-precision reference."},
      .columns = {{"id", {}},
                  {"CPU s", {"seconds", "least", "largest", "repetitions"}},
                  {"µs/step", {"microseconds"}},
                  {"speed-up", {"speed_up"}},
                  {"iterations/step", {"iterations"}},
                  {"error q", {"error"}},
                  {"error q'", {"error"}},
                  {"error q''", {"error"}},
                  {"set-up s", {"seconds"}},
                  {"remark", {}}},
      .rows = {}};
  define_time(table, record);
  const std::vector<CandidateKey> keys = ordered_keys(record, case_name, coordinates);
  const std::optional<CandidateKey> reference = fastest_reference(record, keys);
  for (const CandidateKey& key : keys) {
    const Candidate& candidate = record.candidates.at(key);
    const Measured time = measured(record, key);
    const auto& checked = candidate.verification;
    std::optional<double> step, position, velocity, acceleration;
    if (time.seconds)
      step = time.seconds->value / static_cast<double>(record.settings.instants) * 1e6;
    if (checked) position = checked->position;
    if (checked) velocity = checked->velocity;
    if (checked) acceleration = checked->acceleration;
    table.rows.push_back(
        {text_entry(key.id), range_entry(time), number_entry(step, 4),
         ratio_entry(record, reference, key), number_entry(candidate.iterations_per_step, 3),
         number_entry(position, 2), number_entry(velocity, 2), number_entry(acceleration, 2),
         number_entry(candidate.setup_seconds, 2),
         text_entry(candidate.status == Status::ok ? solvers_text(candidate.solvers)
                                                   : remark(candidate.status, candidate.message))});
  }
  return table;
}

std::vector<std::string> failures(const Record& record) {
  std::vector<std::string> lines;
  for (const auto* candidates : {&record.candidates, &record.wall_candidates})
    for (const auto& [key, candidate] : *candidates)
      if (candidate.status == Status::failed)
        lines.push_back(failure(key, "", remark(candidate.status, candidate.message)));
  for (const auto* requests : {&record.requests, &record.wall_requests})
    for (const Request& request : *requests)
      if (request.status == Status::failed)
        lines.push_back(failure(request.candidate, "/request:" + request.name,
                                remark(request.status, request.message)));
  for (const Peer& peer : record.peers)
    if (peer.candidate.status == Status::failed)
      lines.push_back(
          failure(key_of(peer), "", remark(peer.candidate.status, peer.candidate.message)));
  return lines;
}

}  // namespace desmo::report
