// The paper's comparison in each kind of coordinates.
#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <utility>

#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

/// Kinds of coordinates, in the order of columns; the first is the paper's.
constexpr std::array kinds{"natural", "basis", "reference", "relative"};

/// Two formulations, and words for the ratio time of reference / time of variant. The experiment
/// measures no other formulations (compared_ids()).
struct Pair {
  std::string_view question, reference, variant;
};
constexpr std::array pairs{
    Pair{"group, dense, over global CHOLMOD", "global_automatic_cholmod", "group_automatic_lapack"},
    Pair{"group, dense, over global UMFPACK", "global_automatic_umfpack", "group_automatic_lapack"},
    Pair{"group, dense, over global KLU", "global_automatic_klu", "group_automatic_lapack"},
    Pair{"group over global, both CHOLMOD", "global_automatic_cholmod", "group_automatic_cholmod"},
    Pair{"group over global, both UMFPACK", "global_automatic_umfpack", "group_automatic_umfpack"},
    Pair{"group over global, both KLU", "global_automatic_klu", "group_automatic_klu"},
    Pair{"in groups, dense over KLU", "group_automatic_klu", "group_automatic_lapack"},
    Pair{"generated equations over loops, dense", "group_automatic_lapack",
         "group_symbolic_lapack"},
    Pair{"generated elimination over dense", "group_symbolic_lapack", "group_symbolic_inlined"},
    Pair{"explicit order over elimination", "group_symbolic_inlined", "group_symbolic_explicit"}};

std::string kind_of(std::string_view id) {
  const std::string_view given = setting(id, "coordinates");
  return given.empty() ? kinds.front() : std::string(given);
}

/// Returns the id, in another kind of coordinates, of a formulation in natural ones. The kind
/// becomes the first setting.
std::string id_in(std::string_view id, std::string_view kind) {
  if (kind == kinds.front()) return std::string(id);
  const std::size_t slash = std::min(id.find('/'), id.size());
  return std::string(id.substr(0, slash)) + "/coordinates:" + std::string(kind) +
         std::string(id.substr(slash));
}

/// Returns the time recorded for a formulation in a kind of coordinates; null where there is none,
/// or it failed. id: its id in natural coordinates
const ModelledTime* find(const Record& record, const CaseSize& place, std::string_view id,
                         std::string_view kind) {
  const auto found = record.modelled.find({place, id_in(id, kind)});
  return found == record.modelled.end() || found->second.status != Status::ok ? nullptr
                                                                              : &found->second;
}

/// Returns the mean speed-up of a pair in a kind of coordinates over all sizes; missing_mark where
/// a size has none.
Entry ratio_in(const Record& record, const std::string& case_name,
               const std::set<std::int64_t>& sizes, const Pair& pair, std::string_view kind) {
  std::vector<SpeedUp> found;
  for (const std::int64_t n : sizes) {
    const ModelledTime *reference = find(record, {case_name, n}, pair.reference, kind),
                       *variant = find(record, {case_name, n}, pair.variant, kind);
    if (!reference || !variant) return note_entry(missing_mark);
    found.push_back(speed_up(reference->time, variant->time));
  }
  return ratio_entry(mean(found));
}

Table ratios(const Record& record) {
  Table table = headed_table("modelling_ratios");
  for (const auto& [case_name, sizes] : recorded_sizes(record.modelled))
    for (const Pair& pair : pairs) {
      std::vector<Entry> row{case_name, std::string(pair.question)};
      for (const char* kind : kinds) row.push_back(ratio_in(record, case_name, sizes, pair, kind));
      table.rows.push_back(std::move(row));
    }
  return table;
}

Entry count_of(const std::optional<std::int64_t>& number) {
  return number ? Entry(*number) : note_entry(missing_mark);
}

/// Shows all that was recorded: a row for each case, size and formulation.
Table all_times(const Record& record) {
  Table table = headed_table("modelling");
  for (const auto& [key, entry] : record.modelled) {
    std::vector<Entry> row{key.case_name, kind_of(key.id), without_setting(key.id, "coordinates"),
                           key.coordinates};
    if (entry.status == Status::ok) {
      row.insert(row.end(), {step_time_entry(entry.time), entry.unknowns, count_of(entry.entries),
                             count_of(entry.condensation), number_entry(entry.condition, 2),
                             number_entry(entry.iterations_per_step, 3),
                             error_entry(entry.verification->position), ""});
    } else {
      row.push_back(note_entry(failed_mark));
      row.resize(table.columns.size() - 1, note_entry(missing_mark));
      row.push_back(entry.message);
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Returns the times of a step in each kind of coordinates, divided by a unit [s]; missing_mark for
/// all where the unit is missing.
std::vector<Entry> times_of(const Record& record, const CaseSize& place, std::string_view id,
                            const std::optional<double>& unit) {
  std::vector<Entry> times;
  for (const char* kind : kinds) {
    const ModelledTime* entry = find(record, place, id, kind);
    times.push_back(number_entry(
        entry && unit ? std::optional(std::ranges::min(entry->time.seconds) / *unit) : std::nullopt,
        3));
  }
  return times;
}

/// Shows the last case at its largest size: a row for each formulation, a column for each kind of
/// coordinates.
Table in_short(const Record& record) {
  const CaseSize& last = record.modelled.rbegin()->first;
  Table table = headed_table("modelling_in_short",
                             {{"case", last.case_name}, {"coordinates", last.coordinates}});
  std::set<std::string> ids;
  for (const auto& [key, entry] : record.modelled)
    if (key.is_at(last)) ids.insert(without_setting(key.id, "coordinates"));
  for (const std::string& id : ids) {
    table.rows.push_back(times_of(record, last, id, 1e-6));
    table.rows.back().insert(table.rows.back().begin(), id);
  }
  return table;
}

/// Returns the first numbers of entries as a list in a sentence: "0.69, 0.95, 0.80 and 1.12".
std::string in_all_kinds(std::span<const Entry> entries) {
  std::vector<std::string> texts;
  for (const Entry& entry : entries)
    texts.push_back(entry.has_number() ? entry.digits.front() : missing_mark);
  return in_a_row(texts);
}

}  // namespace

std::vector<Section> modelling_sections(const Record& record) {
  Table found = ratios(record);
  const auto ratio = [&](std::string_view question) {
    const auto of_last_case = std::ranges::find_if(
        found.rows.end() - pairs.size(), found.rows.end(),
        [&](const std::vector<Entry>& row) { return row[1].shown == question; });
    return in_all_kinds(std::span(*of_last_case).subspan(2));
  };
  const CaseSize& last = record.modelled.rbegin()->first;
  constexpr std::string_view generated = "group_symbolic_explicit";
  const ModelledTime* natural = find(record, last, generated, kinds.front());
  const std::optional<double> unit =
      natural ? std::optional(std::ranges::min(natural->time.seconds)) : std::nullopt;
  const TextValues values{{"case", last.case_name},
                          {"cholmod", ratio("group, dense, over global CHOLMOD")},
                          {"umfpack", ratio("group, dense, over global UMFPACK")},
                          {"klu", ratio("group, dense, over global KLU")},
                          {"in_groups", ratio("in groups, dense over KLU")},
                          {"generated", in_all_kinds(times_of(record, last, generated, unit))}};
  return {headed_section("modelling_front", values, {in_short(record)}),
          headed_section("modelling_section", {}, {std::move(found), all_times(record)})};
}

}  // namespace desmo::report
