#include "bench/experiments/extremes/table.h"

#include <algorithm>
#include <map>
#include <utility>

#include "bench/experiments/extremes/case_run.h"
#include "bench/experiments/extremes/known_case.h"
#include "formulations/id.h"

namespace desmo::extremes {

namespace {

/// Returns the variant that solves the same parts with the same equations, but chooses pivots anew
/// at every position.
const Variant& with_new_pivots(const Variant& v) {
  return find_variant(v.id.substr(0, v.id.rfind('_')) + "_eigen");
}

std::vector<const Variant*> matching(const std::regex& formulations) {
  std::vector<const Variant*> all;
  for (const Variant& v : variants())
    if (std::regex_search(v.id, formulations)) all.push_back(&v);
  return all;
}

/// Returns a row's selected cases. Adds the row's first case where a selected one is compared with
/// it.
std::vector<ExtremeCase> selected(std::vector<ExtremeCase> all, const std::regex& names) {
  const auto is_chosen = [&](const ExtremeCase& c) { return std::regex_search(c.name, names); };
  const bool is_measured = std::ranges::any_of(
      all, [&](const ExtremeCase& c) { return c.bound == Bound::first_case && is_chosen(c); });
  const ExtremeCase* const yardstick = is_measured ? all.data() : nullptr;
  std::vector<ExtremeCase> chosen;
  for (ExtremeCase& c : all)
    if (&c == yardstick || is_chosen(c)) chosen.push_back(std::move(c));
  return chosen;
}

Configuration configuration(const Variant& v, const ExtremeCase& c) {
  // Parsed with another id: that v does not offer the settings is a result, not an error.
  Settings settings = parse_id("group_automatic_eigen" + c.settings).settings;
  settings.tolerance = c.scene.tolerance;
  return {&v, settings};
}

}  // namespace

std::vector<Result> row_results(const Extreme& row, const Selection& selection) {
  std::vector<Result> results;
  const std::vector<const Variant*> chosen = matching(selection.formulations);
  std::map<const Variant*, CaseRun> first;
  std::vector<ExtremeCase> cases = selected(row.cases(selection.extent), selection.cases);
  for (ExtremeCase& c : cases) {
    const KnownCase known = make_known_case(c);
    c.scene.mechanism = {};  // a million dyads take gigabytes, and the known case has its model
    std::map<const Variant*, CaseRun> anew;
    for (const Variant* v : chosen) {
      const Variant& other = with_new_pivots(*v);
      if (c.bound == Bound::new_pivots && !anew.contains(&other))
        anew.emplace(&other, run_case(known, {&other, {.tolerance = c.scene.tolerance}}));
      const Configuration tried = configuration(*v, c);
      CaseRun a = run_case(known, tried);
      const CaseRun* yardstick = nullptr;
      if (c.bound == Bound::new_pivots) yardstick = &anew.at(&other);
      if (c.bound == Bound::first_case && first.contains(v)) yardstick = &first.at(v);
      results.push_back({&row, c.name, id_with(*v, tried.settings), verify(known, a, yardstick)});
      first.try_emplace(v, std::move(a));
    }
    if (selection.on_case_done) selection.on_case_done(1.0 / static_cast<double>(cases.size()));
  }
  return results;
}

}  // namespace desmo::extremes
