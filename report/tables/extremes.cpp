// Stability at the extremes: what formulations do in extreme cases.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "report/statistics/variants.h"
#include "report/tables/entries.h"
#include "report/tables/tables.h"

namespace desmo::report {
namespace {

using Verdict = ExtremeResult::Verdict;
using Results = std::vector<const ExtremeResult*>;

std::int64_t count(const Results& results, Verdict verdict) {
  return std::ranges::count(results, verdict, [](const ExtremeResult* r) { return r->verdict; });
}

/// Returns the largest quotient error / floor, over all levels and results that were compared; none
/// where nothing was, or all floors are 0.
std::optional<double> worst_over_floor(const Results& results) {
  std::optional<double> worst;
  for (const ExtremeResult* r : results) {
    if (!r->worst) continue;
    const auto& [position, velocity, acceleration] = *r->worst;
    for (const ExtremeError& e : {position, velocity, acceleration})
      if (e.floor > 0) worst = std::max(worst.value_or(0), e.error / e.floor);
  }
  return worst;
}

Entry results_entry(const Results& results) {
  const std::int64_t tried = std::ssize(results) - count(results, Verdict::not_applicable);
  if (tried == 0) return note_entry("n/a");
  const std::int64_t defects = count(results, Verdict::defect),
                     missed = count(results, Verdict::missed);
  const std::string note = defects ? "DEFECT" : missed ? "missed" : "ok";
  Entry e{note, {"", "", ""}, note};
  if (const std::int64_t bad = defects ? defects : missed) {
    e.digits[0] = std::to_string(bad);
    e.digits[1] = std::to_string(tried);
    e.shown += " " + e.digits[0] + " of " + e.digits[1];
  }
  if (const auto worst = worst_over_floor(results)) {
    e.digits[2] = write(*worst, {.scientific = true, .decimals = 0});
    e.shown += ", " + e.digits[2];
  }
  return e;
}

void add_verdicts(std::vector<Entry>& row, const Results& results) {
  for (const Verdict v :
       {Verdict::as_expected, Verdict::missed, Verdict::defect, Verdict::not_applicable})
    row.push_back(count(results, v));
}

/// Returns the id and the reason of the first result with the gravest verdict; empty where all are
/// as expected.
std::string example(const Results& results) {
  for (const Verdict v : {Verdict::defect, Verdict::missed, Verdict::not_applicable})
    for (const ExtremeResult* r : results)
      if (r->verdict == v) return r->id + ": " + r->reason;
  return {};
}

/// The results of a record, by row, by case, and by formulation and row.
struct Sorted {
  explicit Sorted(const Record& record) {
    for (const ExtremeResult& r : record.extremes) {
      const std::string formulation(without_settings(r.id));
      if (!std::ranges::count(formulations, formulation)) formulations.push_back(formulation);
      all.push_back(&r);
      rows[r.row].push_back(&r);
      cases[{r.row, r.case_name}].push_back(&r);
      by_both[{formulation, r.row}].push_back(&r);
    }
  }
  Results all;
  std::vector<std::string> formulations;  ///< ids without settings, in the record's order
  std::map<std::int64_t, Results> rows;
  std::map<std::pair<std::int64_t, std::string>, Results> cases;
  std::map<std::pair<std::string, std::int64_t>, Results> by_both;
};

std::string name_of(const ExtremeRow& row) { return std::to_string(row.number) + " " + row.name; }

}  // namespace

std::vector<Section> extremes_sections(const Record& record) {
  Sorted sorted(record);
  const Results& all = sorted.all;
  const std::int64_t defects = count(all, Verdict::defect);
  const TextValues counts{{"defects", defects},
                          {"tried", std::ssize(all) - count(all, Verdict::not_applicable)},
                          {"expected", count(all, Verdict::as_expected)},
                          {"missed", count(all, Verdict::missed)}};
  Table matrix = headed_table("extremes"), rows = headed_table("extreme_rows"),
        cases = headed_table("extreme_cases");
  for (const ExtremeRow& row : record.extreme_rows) {
    matrix.columns.push_back({name_of(row), {"cases", "of", "error_over_floor"}});
    rows.rows.push_back({name_of(row), row.extreme, row.expected});
    add_verdicts(rows.rows.back(), sorted.rows[row.number]);
  }
  for (const std::string& name : sorted.formulations) {
    matrix.rows.push_back({name});
    for (const ExtremeRow& row : record.extreme_rows)
      matrix.rows.back().push_back(results_entry(sorted.by_both[{name, row.number}]));
  }
  for (const auto& [place, results] : sorted.cases) {
    cases.rows.push_back({place.first, place.second});
    add_verdicts(cases.rows.back(), results);
    cases.rows.back().push_back(example(results));
  }
  Section front =
      headed_section("extremes_front", counts,
                     {std::move(matrix), excerpt(rows, headed_table("extremes_in_short"))});
  front.paragraphs = {
      sentence(defects == 0 ? "extremes_front.none" : "extremes_front.defects", counts)};
  return {std::move(front),
          headed_section("extremes_section", {}, {std::move(rows), std::move(cases)})};
}

}  // namespace desmo::report
