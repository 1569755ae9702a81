// The best formulations of one thread, held against the global reference like for like.
#include <algorithm>
#include <functional>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::string_view truck_case = variants[truck_global].case_name;

using Holds = std::function<bool(std::string_view id)>;

/// The first guess and the tolerance that an id names; both empty: the paper's.
struct Start {
  std::string guess, tolerance;
  bool operator==(const Start&) const = default;
};

Start start_of(std::string_view id) {
  return {std::string(setting(id, "guess")), std::string(setting(id, "tolerance"))};
}

Batch batch_of(std::string_view id) {
  return !setting(id, "lanes").empty()      ? Batch::lanes
         : !setting(id, "segments").empty() ? Batch::segments
                                            : Batch::none;
}

/// Whether it is global_automatic_<sparse>, whatever its settings.
bool is_reference(std::string_view id) {
  return std::ranges::any_of(sparse_families, [&](std::string_view family) {
    return id.substr(0, id.find('/')) == "global_automatic_" + std::string(family);
  });
}

/// The truck's largest size at which something has settings, or the largest of all; 0: none.
std::int64_t size_compared(const Record& record) {
  const std::vector<std::int64_t> sizes = recorded_sizes(record, truck_case);
  std::int64_t size = 0;
  for (const auto& [key, candidate] : record.candidates)
    if (key.case_name == truck_case && has_settings(key.id) && !is_beside_peers(record, key.id))
      size = std::max(size, key.coordinates);
  return size > 0 || sizes.empty() ? size : sizes.back();
}

/// The fastest of those that something holds of.
std::optional<CandidateKey> fastest(const Record& record, const Holds& holds) {
  const std::int64_t size = size_compared(record);
  std::optional<CandidateKey> found;
  double least = 0;
  for (const auto& [key, candidate] : record.candidates) {
    if (key.case_name != truck_case || key.coordinates != size || !holds(key.id) ||
        is_beside_peers(record, key.id))
      continue;
    const Measured time = measured(record, key);
    if (!time.seconds || (found && time.seconds->value >= least)) continue;
    found = key;
    least = time.seconds->value;
  }
  return found;
}

std::optional<CandidateKey> reference_with(const Record& record, const Start& start) {
  return fastest(record,
                 [&](std::string_view id) { return is_reference(id) && start_of(id) == start; });
}

std::optional<CandidateKey> best_reference(const Record& record) {
  return fastest(record, is_reference);
}

std::optional<CandidateKey> generated_with(const Record& record, const Start& start, Batch batch) {
  return fastest(record, [&](std::string_view id) {
    return !id.starts_with("global_") && start_of(id) == start && batch_of(id) == batch;
  });
}

MeasuredSpeedUp over(const Record& record, const std::optional<CandidateKey>& reference,
                     const CandidateKey& key) {
  if (!reference) return {std::nullopt, missing_mark};
  return measured_speed_up(record, *reference, key);
}

Best compared_with_references(const Record& record, const CandidateKey& key) {
  return {key, over(record, reference_with(record, start_of(key.id)), key),
          over(record, reference_with(record, {}), key)};
}

void add_row(Table& table, const Record& record, const std::string& what,
             const std::optional<CandidateKey>& key) {
  if (!key) return;
  const Best best = compared_with_references(record, *key);
  const auto ratio = [&](const MeasuredSpeedUp& times, const Start& start) {
    return key == reference_with(record, start) ? reference_entry() : ratio_entry(times);
  };
  table.rows.push_back({what, key->id, instant_entry(record, measured(record, *key), 3),
                        ratio(best.like_for_like, start_of(key->id)),
                        ratio(best.papers_settings, {})});
}

}  // namespace

std::optional<Best> best_generated(const Record& record, Batch batch) {
  const std::optional<CandidateKey> reference = best_reference(record);
  if (!reference) return std::nullopt;
  const auto key = generated_with(record, start_of(reference->id), batch);
  return key ? std::optional(compared_with_references(record, *key)) : std::nullopt;
}

Table best_formulations(const Record& record) {
  Table table = headed_table("best", {{"coordinates", size_compared(record)}});
  const std::optional<CandidateKey> paper = reference_with(record, {}),
                                    best = best_reference(record);
  add_row(table, record, "global, paper's settings", paper);
  add_row(table, record, "generated elimination, paper's settings",
          generated_with(record, {}, Batch::none));
  if (!best || best == paper) return table;
  const Start start = start_of(best->id);
  add_row(table, record, "global, best settings", best);
  add_row(table, record, "generated elimination, best settings",
          generated_with(record, start, Batch::none));
  add_row(table, record, "the same, in lanes", generated_with(record, start, Batch::lanes));
  add_row(table, record, "the same, in segments instead of batches",
          generated_with(record, start, Batch::segments));
  return table;
}

}  // namespace desmo::report
