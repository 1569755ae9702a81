// The table that shows how the paper's speed-ups depend on step, tolerance and guess. The paper
// does not publish its dimensions, motion and step.
#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

constexpr double min_tolerance = 1e-12, max_tolerance = 1e-6;  // range of tolerances shown, ≤

/// A speed-up of the paper: indices of its two analyses in `paper_variants`.
struct Claimed {
  std::size_t reference, variant;
};
constexpr std::array<Claimed, 5> claimed{{{0, 1}, {2, 3}, {2, 4}, {2, 5}, {2, 6}}};

/// A value of one setting, while all other settings are the paper's.
struct Variation {
  std::string what, value;  ///< words for the setting and its value
  double step;              ///< time between two instants [s]
  Configuration settings;
};

std::vector<Variation> variations(const Record& record) {
  const double usual_step = record.settings.step_seconds;
  std::set<double> steps;
  Points points;
  std::map<double, std::string> tolerances{{record.settings.tolerance, ""}};
  for (const NamedPoint& entry : record.points) {
    const auto& [key, point] = entry;
    const Configuration& c = point.configuration;
    if (c.has_papers_settings() && c.iterations.empty() && !c.tolerance.empty())
      tolerances.emplace(std::strtod(c.tolerance.c_str(), nullptr), c.tolerance);
    steps.insert(key.series.step_seconds);
    points.push_back(&entry);
  }
  std::vector<Variation> all;
  for (const double step : steps)
    all.push_back({"step", write_shortest(std::round(step * 1e9) / 1e6) + " ms", step, {}});
  for (auto t = tolerances.rbegin(); t != tolerances.rend(); ++t)
    if (min_tolerance <= t->first && t->first <= max_tolerance)
      all.push_back({"tolerance", write_shortest(t->first), usual_step, {.tolerance = t->second}});
  for (const std::string& guess : guesses_of(points))
    all.push_back({"guess", guess, usual_step, {.guess = guess}});
  return all;
}

/// Finds the point of a variant with a variation, at the size of drawn_series(); returns null when
/// it was not tried.
const NamedPoint* find_variant(const Record& record, const PaperVariant& variant,
                               std::string_view family, const Variation& variation) {
  const std::vector<SeriesKey> all = drawn_series(record);
  const auto series = std::ranges::find(all, variant.case_name, &SeriesKey::case_name);
  if (series == all.end()) return nullptr;
  const CandidateKey key = family_key(variant, series->coordinates, family);
  Configuration wanted = variation.settings;
  wanted.formulation = key.id;
  for (const NamedPoint& point : record.points)
    if (point.first.series.is_at(key) && point.first.series.step_seconds == variation.step &&
        point.second.configuration == wanted)
      return &point;
  return nullptr;
}

Entry claim_entry(const Record& record, std::string_view family, const Claimed& claim,
                  const Variation& variation) {
  const NamedPoint* reference =
      find_variant(record, paper_variants[claim.reference], family, variation);
  const NamedPoint* variant =
      find_variant(record, paper_variants[claim.variant], family, variation);
  if (!reference || !variant) return note_entry(missing_mark);
  if (!is_solved(*reference) || !is_solved(*variant)) return note_entry(failed_mark);
  return ratio_entry(speed_up(reference->second.time, variant->second.time));
}

}  // namespace

Table sensitivity(const Record& record) {
  Table table = headed_table("sensitivity");
  for (const Claimed& claim : claimed)
    table.columns.push_back(
        {family_name(paper_variants[claim.variant], "<sparse>"), {"speed_up", "low", "high"}});
  for (const std::string_view family : sparse_families)
    for (const Variation& variation : variations(record)) {
      std::vector<Entry> row{std::string(family), variation.what, variation.value};
      bool any = false;
      for (const Claimed& claim : claimed) {
        row.push_back(claim_entry(record, family, claim, variation));
        any = any || row.back().shown != missing_mark;
      }
      if (any) table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace desmo::report
