// All that was recorded, not only what the paper compares.
#include <algorithm>
#include <limits>

#include "report/statistics/paper.h"
#include "report/tables/entries.h"
#include "report/tables/record_words.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

/// Returns the fastest first; what has no time comes last, by id. What stands next to peers is
/// shown there.
std::vector<CandidateKey> ordered_keys(const Record& record, const std::string& case_name,
                                       std::int64_t coordinates) {
  std::vector<CandidateKey> keys;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == case_name && key.coordinates == coordinates &&
        !is_beside_peers(record, key.id))
      keys.push_back(key);
  std::ranges::stable_sort(keys, {}, [&](const CandidateKey& key) {
    const Measured time = measured(record, key);
    return time.seconds ? time.seconds->value : std::numeric_limits<double>::infinity();
  });
  return keys;
}

/// A ratio without its interval.
Entry plain_ratio(const Record& record, const std::optional<CandidateKey>& reference,
                  const CandidateKey& key) {
  if (!reference) return note_entry(missing_mark);
  if (key == *reference) return reference_entry();
  const MeasuredSpeedUp ratio = measured_speed_up(record, *reference, key);
  if (!ratio.speed_up) return note_entry(ratio.mark);
  Entry entry = digits_entry(write(ratio.speed_up->value, ratio_digits(ratio.speed_up->value)));
  if (ratio.speed_up->inconclusive()) add_note(entry, inconclusive_mark);
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

}  // namespace

Table every_formulation(const Record& record, const std::string& case_name,
                        std::int64_t coordinates) {
  Table table = headed_table("formulations_case", {{"case", case_name},
                                                   {"coordinates", coordinates},
                                                   {"time", time_word(record)},
                                                   {"repetitions", repetitions(record)}});
  define_time(table, record);
  const std::vector<CandidateKey> keys = ordered_keys(record, case_name, coordinates);
  // KLU's block triangular form is no setting of the paper's: on some mechanisms it costs time.
  const auto reference = fastest(record, case_name, coordinates, [](std::string_view id) {
    return is_reference(id) && !has_settings(without_setting(std::string(id), "btf"));
  });
  for (const CandidateKey& key : keys) {
    const Candidate& candidate = record.candidates.at(key);
    const Measured time = measured(candidate);
    std::vector<Entry> row{key.id,
                           seconds_entry(time, Spread::range),
                           instant_entry(record, time),
                           plain_ratio(record, reference, key),
                           plain_ratio(record, reference_like(record, key), key),
                           number_entry(candidate.iterations_per_step, 3)};
    add_errors(row, candidate);
    row.push_back(number_entry(candidate.setup_seconds, 2));
    row.push_back(candidate.status == Status::ok ? solvers_text(candidate.solvers)
                                                 : remark(candidate));
    table.rows.push_back(std::move(row));
  }
  return table;
}

// Other sizes than the paper's largest, or the largest there is, are details.
Section every_formulation(const Record& record) {
  Section section = headed_section("formulations");
  for (const std::string& name : recorded_cases(record)) {
    const std::vector<std::int64_t> sizes = recorded_sizes(record, name);
    const bool published = std::ranges::count(sizes, published_sizes().back()) > 0;
    for (const std::int64_t size : sizes) {
      section.tables.push_back(every_formulation(record, name, size));
      section.tables.back().detail = size != (published ? published_sizes() : sizes).back();
    }
  }
  return section;
}

}  // namespace desmo::report
