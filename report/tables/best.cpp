// The best formulations of one thread, held against the global reference like for like.
#include <algorithm>
#include <functional>

#include "report/tables/entries.h"
#include "report/tables/tables.h"
#include "report/text/texts.h"

namespace desmo::report {
namespace {

constexpr std::string_view truck_case = variants[truck_global].case_name;

std::string_view side_by_side_of(std::string_view id) {
  return !setting(id, "lanes").empty()      ? "lanes"
         : !setting(id, "segments").empty() ? "segments"
                                            : "";
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

std::optional<CandidateKey> papers_reference(const Record& record) {
  return reference_like(record, {std::string(truck_case), size_compared(record), {}});
}

std::optional<CandidateKey> best_reference(const Record& record) {
  return fastest(record, std::string(truck_case), size_compared(record), is_reference);
}

/// Finds the fastest by groups or blocks with the guess and the tolerance of an id.
std::optional<CandidateKey> generated_like(const Record& record, std::string_view like,
                                           std::string_view side_by_side) {
  return fastest(record, std::string(truck_case), size_compared(record), [&](std::string_view id) {
    return !id.starts_with("global_") && setting(id, "guess") == setting(like, "guess") &&
           setting(id, "tolerance") == setting(like, "tolerance") &&
           side_by_side_of(id) == side_by_side;
  });
}

MeasuredSpeedUp over(const Record& record, const std::optional<CandidateKey>& reference,
                     const CandidateKey& key) {
  if (!reference) return {std::nullopt, missing_mark};
  return measured_speed_up(record, *reference, key);
}

void add_row(Table& table, const Record& record, const std::string& what,
             const std::optional<CandidateKey>& key) {
  if (!key) return;
  const auto over_entry = [&](const std::optional<CandidateKey>& reference) {
    return key == reference ? reference_entry() : ratio_entry(over(record, reference, *key));
  };
  table.rows.push_back({what, key->id, instant_entry(record, measured(record, *key), 3),
                        over_entry(reference_like(record, *key)),
                        over_entry(papers_reference(record))});
}

}  // namespace

std::optional<Best> best_generated(const Record& record, std::string_view side_by_side) {
  const std::optional<CandidateKey> reference = best_reference(record);
  if (!reference) return std::nullopt;
  const auto key = generated_like(record, reference->id, side_by_side);
  if (!key) return std::nullopt;
  return Best{*key, over(record, reference_like(record, *key), *key),
              over(record, papers_reference(record), *key)};
}

Table best_formulations(const Record& record) {
  Table table = headed_table("best", {{"coordinates", size_compared(record)}});
  const std::optional<CandidateKey> paper = papers_reference(record), best = best_reference(record);
  add_row(table, record, "global, paper's settings", paper);
  add_row(table, record, "generated elimination, paper's settings", generated_like(record, "", ""));
  if (!best || best == paper) return table;
  add_row(table, record, "global, best settings", best);
  add_row(table, record, "generated elimination, best settings",
          generated_like(record, best->id, ""));
  add_row(table, record, "the same, in lanes", generated_like(record, best->id, "lanes"));
  add_row(table, record, "the same, in segments instead of batches",
          generated_like(record, best->id, "segments"));
  return table;
}

}  // namespace desmo::report
