// Stability at the extremes: which formulation does what where most go wrong.
#include <algorithm>
#include <map>
#include <optional>
#include <utility>

#include "report/tables/entries.h"
#include "report/tables/excerpt.h"
#include "report/tables/tables.h"
#include "report/text/digits.h"

namespace desmo::report {
namespace {

using Verdict = ExtremeResult::Verdict;
using Results = std::vector<const ExtremeResult*>;

constexpr const char* defect_mark = "DEFECT";
constexpr const char* not_applicable_mark = "n/a";

/// Results that something holds of.
template <class Holds>
Results results_of(const Record& record, Holds&& holds) {
  Results found;
  for (const ExtremeResult& r : record.extremes)
    if (holds(r)) found.push_back(&r);
  return found;
}

std::size_t count(const Results& results, Verdict verdict) {
  return static_cast<std::size_t>(
      std::ranges::count(results, verdict, [](const ExtremeResult* r) { return r->verdict; }));
}

/// Over all levels and results that were compared.
std::optional<double> worst_over_floor(const Results& results) {
  std::optional<double> worst;
  for (const ExtremeResult* r : results)
    for (int level = 0; r->worst && level < 3; ++level)
      if (const ExtremeError& e = (*r->worst)[level]; e.floor > 0)
        worst = std::max(worst.value_or(0), e.error / e.floor);
  return worst;
}

std::string formulation_of(const ExtremeResult& r) { return r.id.substr(0, r.id.find('/')); }

/// In the record's order.
std::vector<std::string> formulations(const Record& record) {
  std::vector<std::string> names;
  for (const ExtremeResult& r : record.extremes)
    if (!std::ranges::count(names, formulation_of(r))) names.push_back(formulation_of(r));
  return names;
}

Entry results_entry(const Results& results) {
  const std::size_t tried = results.size() - count(results, Verdict::not_applicable);
  if (tried == 0) return note_entry(not_applicable_mark);
  const std::size_t defects = count(results, Verdict::defect),
                    missed = count(results, Verdict::missed);
  const std::string note = defects ? defect_mark : missed ? "missed" : "ok";
  Entry e{note, {"", "", ""}, note};
  if (const std::size_t bad = defects ? defects : missed) {
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
    row.push_back(count_entry(count(results, v)));
}

/// The first of the worst kind there is.
std::string example(const Results& results) {
  for (const Verdict v : {Verdict::defect, Verdict::missed, Verdict::not_applicable})
    for (const ExtremeResult* r : results)
      if (r->verdict == v) return r->id + ": " + r->reason;
  return {};
}

Table extremes_by_formulation(const Record& record) {
  Table table = headed_table("extremes");
  for (const ExtremeRow& row : record.extreme_rows)
    table.columns.push_back(
        {std::to_string(row.number) + " " + row.name, {"cases", "of", "error_over_floor"}});
  for (const std::string& name : formulations(record)) {
    std::vector<Entry>& entries = table.rows.emplace_back();
    entries.push_back(name);
    for (const ExtremeRow& row : record.extreme_rows)
      entries.push_back(results_entry(results_of(record, [&](const ExtremeResult& r) {
        return r.row == row.number && formulation_of(r) == name;
      })));
  }
  return table;
}

Table extreme_rows(const Record& record) {
  Table table = headed_table("extreme_rows");
  for (const ExtremeRow& row : record.extreme_rows) {
    std::vector<Entry>& entries = table.rows.emplace_back();
    entries = {std::to_string(row.number) + " " + row.name, row.extreme, row.expected};
    add_verdicts(entries,
                 results_of(record, [&](const ExtremeResult& r) { return r.row == row.number; }));
  }
  return table;
}

/// Shows how many formulations do as expected in every case, and the first that does not.
Table extreme_cases(const Record& record) {
  Table table = headed_table("extreme_cases");
  std::map<std::pair<std::int64_t, std::string>, Results> cases;
  for (const ExtremeResult& r : record.extremes) cases[{r.row, r.case_name}].push_back(&r);
  for (const auto& [place, results] : cases) {
    std::vector<Entry>& entries = table.rows.emplace_back();
    entries = {place.first, place.second};
    add_verdicts(entries, results);
    entries.push_back(example(results));
  }
  return table;
}

}  // namespace

std::vector<Section> extremes_sections(const Record& record) {
  const Results all = results_of(record, [](const ExtremeResult&) { return true; });
  const std::size_t defects = count(all, Verdict::defect);
  Section front = headed_section("extremes_front"), section = headed_section("extremes_section");
  section.paragraphs = {
      sentence(defects == 0 ? "extremes_section.none" : "extremes_section.defects",
               {{"defects", defects},
                {"tried", all.size() - count(all, Verdict::not_applicable)},
                {"expected", count(all, Verdict::as_expected)},
                {"missed", count(all, Verdict::missed)}})};
  section.tables = {extremes_by_formulation(record), extreme_rows(record), extreme_cases(record)};
  front.tables = {excerpt(section.tables[1], headed_table("extremes_in_short"))};
  return {front, section};
}

}  // namespace desmo::report
