#include "bench/experiments/extremes/table.h"

#include <algorithm>
#include <map>
#include <utility>

#include "bench/experiments/extremes/candidate.h"
#include "bench/experiments/extremes/problem.h"
#include "formulations/id.h"

namespace desmo::extremes {

namespace {

/// What solves the same parts by the same equations and makes factors, and chooses their pivots,
/// anew at every position.
const Variant& with_new_pivots(const Variant& v) {
  return find_variant(v.id.substr(0, v.id.rfind('_')) + "_eigen");
}

std::vector<const Variant*> matching(const std::regex& formulations) {
  std::vector<const Variant*> all;
  for (const Variant& v : variants())
    if (std::regex_search(v.id, formulations)) all.push_back(&v);
  return all;
}

/// Of a row's cases those selected, and the first where they are measured by it.
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
  // Parsed without its formulation's leave: what that does not offer is a result.
  Settings settings = parse_id("group_automatic_eigen" + c.settings).settings;
  settings.tolerance = c.scene.tolerance;
  return {&v, settings};
}

/// ", without sensitivity"
std::string note_on(unsigned without) {
  std::string note;
  for (const auto& [monitor, name] : monitor_names)
    if (without & static_cast<unsigned>(monitor)) note += ", without " + std::string(name);
  return note;
}

double condition(const Problem& p) {
  double largest = 0;
  for (const Answers& a : p.answers) largest = std::max(largest, a.condition);
  return largest;
}

}  // namespace

std::vector<Result> row_results(const Extreme& row, const Selection& selection) {
  std::vector<Result> results;
  const std::vector<const Variant*> chosen = matching(selection.formulations);
  std::map<const Variant*, Attempt> first;
  for (ExtremeCase& c : selected(row.cases(selection.extent), selection.cases)) {
    if (selection.say) selection.say(c.name);
    const Problem problem = make_problem(c);
    c.scene.mechanism = {};  // a million dyads take gigabytes, and the problem has its model
    std::map<const Variant*, Attempt> anew;
    for (const Variant* v : chosen) {
      const Variant& other = with_new_pivots(*v);
      if (c.bound == Bound::new_pivots && !anew.contains(&other))
        anew.emplace(&other, attempt(problem, {&other, {.tolerance = c.scene.tolerance}},
                                     selection.without));
      const Configuration tried = configuration(*v, c);
      Attempt a = attempt(problem, tried, selection.without);
      const auto before = first.find(v);
      const Yardsticks yardsticks{before == first.end() ? nullptr : &before->second,
                                  anew.contains(&other) ? &anew.at(&other) : nullptr};
      results.push_back({&row, c.name + note_on(selection.without), id_with(*v, tried.settings),
                         condition(problem), judge(problem, a, yardsticks)});
      if (before == first.end()) first.emplace(v, std::move(a));
    }
  }
  return results;
}

}  // namespace desmo::extremes
