// The paper's dimensions, motion and step are not published. Which of its speed-ups depend on what
// was put in their place?
#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>

#include "report/statistics/selection.h"
#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/precision.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

constexpr std::array tried_guesses{"previous", "linear",   "quadratic",
                                   "hermite3", "hermite5", "adams8"};
constexpr double min_tolerance = 1e-12, max_tolerance = 1e-6;

/// A speed-up of the paper: over which analysis, of which (by position in `variants`).
struct Claimed {
  std::size_t reference, variant;
};
constexpr std::array<Claimed, 5> claimed{{{0, 1}, {2, 3}, {2, 4}, {2, 5}, {2, 6}}};

/// What was chosen otherwise, all else as in the paper.
struct Variation {
  std::string what, value;
  double step;  ///< s
  Configuration settings;
};

bool same_settings(const Configuration& a, const Configuration& b) {
  return a.guess == b.guess && a.jacobian == b.jacobian && a.scalar == b.scalar &&
         a.factorisation == b.factorisation && a.iterations == b.iterations &&
         a.tolerance == b.tolerance && a.others == b.others;
}

std::vector<Variation> variations(const Record& record) {
  const double usual_step = record.settings.step_seconds;
  std::set<double> steps;
  std::map<double, std::string> tolerances{{record.settings.tolerance, ""}};
  for (const auto& [key, point] : record.points) {
    const Configuration& c = point.configuration;
    if (c.has_papers_settings() && c.iterations.empty() && !c.tolerance.empty())
      tolerances.emplace(std::strtod(c.tolerance.c_str(), nullptr), c.tolerance);
    steps.insert(key.series.step_seconds);
  }
  std::vector<Variation> all;
  for (const double step : steps)
    all.push_back({"step", write_shortest(std::round(step * 1e9) / 1e6) + " ms", step, {}});
  for (auto t = tolerances.rbegin(); t != tolerances.rend(); ++t)
    if (min_tolerance <= t->first && t->first <= max_tolerance) {
      all.push_back({"tolerance", write_shortest(t->first), usual_step, {}});
      all.back().settings.tolerance = t->second;
    }
  for (const char* guess : tried_guesses) {
    const auto is_tried = [&](const NamedPoint& p) {
      return p.second.configuration.guess == guess;
    };
    if (std::ranges::none_of(record.points, is_tried)) continue;  // as in a record older than it
    all.push_back({"guess", guess, usual_step, {}});
    all.back().settings.guess = guess;
  }
  return all;
}

/// Of a formulation at the case's size of the main series; null when it was not tried.
const NamedPoint* find(const Record& record, const CandidateKey& candidate,
                       const Variation& variation) {
  for (const NamedPoint& point : record.points)
    if (point.first.series.case_name == candidate.case_name &&
        point.first.series.coordinates == candidate.coordinates &&
        point.first.series.step_seconds == variation.step &&
        point.second.configuration.formulation == candidate.id &&
        same_settings(point.second.configuration, variation.settings))
      return &point;
  return nullptr;
}

struct Found {
  const NamedPoint *reference, *variant;
  bool both_solved() const {
    return reference && variant && is_solved(*reference) && is_solved(*variant);
  }
};

Found found(const Record& record, std::string_view family, const Claimed& claim,
            const Variation& variation) {
  const Variant &reference = variants[claim.reference], &variant = variants[claim.variant];
  const auto series = main_series(record, variant.case_name);
  if (!series) return {nullptr, nullptr};
  return {find(record, family_key(reference, series->coordinates, family), variation),
          find(record, family_key(variant, series->coordinates, family), variation)};
}

Entry entry_of(const Found& pair) {
  if (pair.both_solved()) return ratio_entry(speed_up(*pair.reference, *pair.variant));
  const bool tried = pair.reference && pair.variant;
  return note_entry(tried ? failed_mark : missing_mark);
}

}  // namespace

Table sensitivity(const Record& record) {
  Table table{
      .name = "sensitivity",
      .title = "Table 2 with other steps, tolerances and guesses",
      .notes = {"Speed-up of each analysis over the global one with the same sparse solver, both "
                "with the same step, tolerance and guess, all else as in the paper, at each case's "
                "largest size; FBL-TP over FBL-G, the others over TS-G. Ratios of the least times "
                "of a step [from the one over the other's second least to the reverse]; " +
                inconclusive_note() + "."},
      .columns = {{"sparse solver", {}}, {"varied", {}}, {"value", {}}},
      .rows = {}};
  for (const Claimed& claim : claimed)
    table.columns.push_back(
        {family_name(variants[claim.variant], "<sparse>"), {"speed_up", "low", "high"}});
  for (const std::string_view family : sparse_families)
    for (const Variation& variation : variations(record)) {
      std::vector<Entry> row{text_entry(std::string(family)), text_entry(variation.what),
                             text_entry(variation.value)};
      bool any = false;
      for (const Claimed& claim : claimed) {
        row.push_back(entry_of(found(record, family, claim, variation)));
        any = any || row.back().shown != missing_mark;
      }
      if (any) table.rows.push_back(std::move(row));
    }
  return table;
}

}  // namespace desmo::report
