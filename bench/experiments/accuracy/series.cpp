#include "bench/experiments/accuracy/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <ranges>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include "bench/experiments/accuracy/settings_grid.h"
#include "bench/kit/candidate_name.h"
#include "bench/kit/variant_costs.h"
#include "formulations/algebra/backend.h"

namespace desmo::accuracy {

namespace {

constexpr double usual_step = 0.01;  // time between instants [s]
constexpr double seconds = 1;        // duration of the motion [s]
constexpr int dense_instants = 6;    // number of instants for dense global solves

/// Formulations with the full settings grid: global and by groups or blocks, automatic and
/// generated, sparse and dense.
constexpr std::array<std::string_view, 11> tuned{
    "global_automatic_klu",    "global_symbolic_klu",     "group_symbolic_klu",
    "group_symbolic_lapack",   "group_symbolic_eigen",    "group_symbolic_inlined",
    "block_symbolic_inlined",  "group_automatic_eigen",   "block_automatic_eigen",
    "group_symbolic_explicit", "block_symbolic_explicit",
};

/// Returns whether a variant is one of the paper's analyses, with the paper's solver or with one
/// that stands in for it.
bool is_in_table_2(const Variant& v) {
  if (v.partition == Partition::block) return false;
  if (v.is_generated()) return !v.is_explicit();
  if (const Backend* const b = find_backend(v.algebra); b && b->dense)
    return v.partition == Partition::group && v.algebra == "lapack";
  return bench::slow_reason(v).empty() &&
         !(v.partition == Partition::global && v.evaluation == Evaluation::symbolic);
}

bool is_tuned(const Variant& v) { return std::ranges::find(tuned, v.id) != tuned.end(); }

/// Returns the settings, at the usual step, that show how Table 2 depends on tolerance and guess.
std::vector<Settings> table_settings() {
  std::vector<Settings> all;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) all.push_back({.tolerance = tolerance});
  for (const Guess guess :
       {Guess::linear, Guess::quadratic, Guess::hermite3, Guess::hermite5, Guess::adams8})
    all.push_back({.guess = guess});
  return all;
}

int instants_of(double step) { return static_cast<int>(std::lround(seconds / step)) + 1; }

/// Returns settings of a formulation at the usual step; none for dense global ones.
std::vector<Settings> usual_settings(const Variant& v, bool largest) {
  std::vector<Settings> all;
  const auto add = [&](const std::vector<Settings>& some) {
    all.insert(all.end(), some.begin(), some.end());
  };
  if (!bench::is_dense_global(v)) add(reduced_settings());
  if (largest && is_tuned(v)) add(full_settings(v));
  if (largest && is_in_table_2(v)) add(table_settings());
  return all;
}

/// Fills a series that has no configurations yet: adds each formulation with each of its settings
/// where the filter finds the name, no id twice. Then adds the series to `all` unless it is empty.
void add(std::vector<AccuracySeries>& all, AccuracySeries series, const std::regex& filter,
         const auto& formulations, const auto& settings_of) {
  bench::CandidateName name{std::string(series.definition->name), series.coordinates, {}};
  std::set<std::string> ids;
  for (const Variant& v : formulations)
    for (const Settings& settings : settings_of(v)) {
      name.id = id_with(v, settings);
      if (ids.insert(name.id).second && std::regex_search(name.text(), filter))
        series.configurations.push_back({&v, settings});
    }
  if (!series.configurations.empty()) all.push_back(std::move(series));
}

}  // namespace

std::vector<AccuracySeries> make_series(bool quick, const std::regex& filter) {
  using Grid = std::vector<Settings>;
  std::vector<AccuracySeries> all;
  for (const Case& c : cases()) {
    const int usual_instants = instants_of(usual_step);
    if (quick) {
      add(all, {&c, c.sizes.front(), usual_step, usual_instants, {}}, filter,
          tuned | std::views::transform(find_variant),
          [](const Variant&) { return reduced_settings(); });
      continue;
    }
    const int largest = c.sizes.back();
    for (const int n : c.sizes) {
      add(all, {&c, n, usual_step, usual_instants, {}}, filter, variants(),
          [&](const Variant& v) { return usual_settings(v, n == largest); });
      add(all, {&c, n, usual_step, dense_instants, {}}, filter, variants(),
          [](const Variant& v) { return bench::is_dense_global(v) ? minimal_settings() : Grid{}; });
    }
    for (const double step : {0.001, 0.002, 0.005, 0.02})
      add(all, {&c, largest, step, instants_of(step), {}}, filter, variants(),
          [](const Variant& v) { return is_in_table_2(v) ? Grid{Settings{}} : Grid{}; });
  }
  return all;
}

}  // namespace desmo::accuracy
