#include "bench/experiments/accuracy/series.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include "bench/experiments/accuracy/settings_grid.h"
#include "bench/kit/variant_costs.h"
#include "formulations/algebra/backend.h"

namespace desmo::accuracy {

namespace {

constexpr double usual_step = 0.01;
constexpr double seconds = 1;
constexpr int dense_instants = 6;

/// Formulations with the full settings grid: global and by groups or blocks, automatic and
/// generated, sparse and dense.
constexpr std::array<std::string_view, 11> tuned{
    "global_automatic_klu",    "global_symbolic_klu",     "group_symbolic_klu",
    "group_symbolic_lapack",   "group_symbolic_eigen",    "group_symbolic_inlined",
    "block_symbolic_inlined",  "group_automatic_eigen",   "block_automatic_eigen",
    "group_symbolic_explicit", "block_symbolic_explicit",
};

/// Tells whether it is one of the paper's analyses, by its own solver or by what stands in for it.
bool is_in_table_2(const Variant& v) {
  if (v.partition == Partition::block) return false;
  if (v.is_generated()) return !v.is_explicit();
  if (const Backend* const b = find_backend(v.algebra); b && b->dense)
    return v.partition == Partition::group && v.algebra == "lapack";
  return bench::slow_reason(v).empty() &&
         !(v.partition == Partition::global && v.evaluation == Evaluation::symbolic);
}

bool is_tuned(const Variant& v) { return std::ranges::find(tuned, v.id) != tuned.end(); }

/// Returns settings of the sensitivity of Table 2, at the usual step.
std::vector<Settings> table_settings() {
  std::vector<Settings> all;
  for (const double tolerance : {1e-6, 1e-8, 1e-10, 1e-12}) all.push_back({.tolerance = tolerance});
  for (const Guess guess :
       {Guess::linear, Guess::quadratic, Guess::hermite3, Guess::hermite5, Guess::adams8})
    all.push_back({.guess = guess});
  return all;
}

/// Adds configurations, each id once.
class Adder {
 public:
  explicit Adder(AccuracySeries& series) : series_(series) {}
  void operator()(const Variant& variant, const std::vector<Settings>& all) {
    for (const Settings& settings : all)
      if (ids_.insert(id_with(variant, settings)).second)
        series_.configurations.push_back({&variant, settings});
  }

 private:
  AccuracySeries& series_;
  std::set<std::string> ids_;
};

int instants_of(double step) { return static_cast<int>(std::lround(seconds / step)) + 1; }

void add_size(std::vector<AccuracySeries>& all, const Case& c, int coordinates, bool largest) {
  AccuracySeries usual{&c, coordinates, usual_step, instants_of(usual_step), {}};
  AccuracySeries dense{&c, coordinates, usual_step, dense_instants, {}};
  Adder add_usual(usual), add_dense(dense);
  for (const Variant& v : variants()) {
    if (bench::is_dense_global(v))
      add_dense(v, minimal_settings());
    else
      add_usual(v, reduced_settings());
    if (largest && is_tuned(v)) add_usual(v, full_settings(v));
    if (largest && is_in_table_2(v)) add_usual(v, table_settings());
  }
  all.push_back(std::move(usual));
  all.push_back(std::move(dense));
}

void add_steps(std::vector<AccuracySeries>& all, const Case& c, int coordinates) {
  for (const double step : {0.001, 0.002, 0.005, 0.02}) {
    AccuracySeries series{&c, coordinates, step, instants_of(step), {}};
    Adder add(series);
    for (const Variant& v : variants())
      if (is_in_table_2(v)) add(v, {Settings{}});
    all.push_back(std::move(series));
  }
}

}  // namespace

std::vector<AccuracySeries> all_series() {
  std::vector<AccuracySeries> all;
  for (const Case& c : cases()) {
    for (const int n : c.sizes) add_size(all, c, n, n == c.sizes.back());
    add_steps(all, c, c.sizes.back());
  }
  return all;
}

std::vector<AccuracySeries> quick_series() {
  std::vector<AccuracySeries> all;
  for (const Case& c : cases()) {
    AccuracySeries series{&c, c.sizes.front(), usual_step, instants_of(usual_step), {}};
    Adder add(series);
    for (const std::string_view id : tuned) add(find_variant(id), reduced_settings());
    all.push_back(std::move(series));
  }
  return all;
}

std::vector<AccuracySeries> matching(std::vector<AccuracySeries> all,
                                     const std::regex& expression) {
  for (AccuracySeries& series : all) {
    const std::string place =
        std::string(series.definition->name) + "/" + std::to_string(series.coordinates) + "/";
    std::erase_if(series.configurations, [&](const Configuration& c) {
      return !std::regex_search(place + id_with(*c.variant, c.settings), expression);
    });
  }
  std::erase_if(all, [](const AccuracySeries& series) { return series.configurations.empty(); });
  return all;
}

}  // namespace desmo::accuracy
