#include "bench/experiments/size/series.h"

#include <algorithm>
#include <array>
#include <optional>
#include <ranges>
#include <string>
#include <utility>

#include "bench/kit/candidate_name.h"
#include "bench/kit/problem.h"
#include "bench/kit/variant_costs.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"

namespace desmo::size {

namespace {

/// Formulations of growth: generated code that solves one part after the other, equal parts at once
/// or segments of the motion at once; and formulations that solve with a sparse library.
constexpr std::array<std::string_view, 6> growing{"group_symbolic_explicit",
                                                  "group_symbolic_explicit/lanes:4",
                                                  "group_symbolic_explicit/segments:4",
                                                  "group_symbolic_inlined",
                                                  "block_symbolic_klu",
                                                  "global_automatic_klu"};

/// Numbers of coordinates of growth: 3 + 111 k, which both cases have.
constexpr std::array coordinates{114,  225,  336,  447,   558,   1002,
                                 2001, 4998, 9993, 22203, 49953, 99903};
constexpr std::array unknowns{10, 15, 20, 25, 30, 40, 50, 60, 75, 90, 110, 140, 200, 300, 400, 500};

constexpr int quick_coordinates = 336, quick_unknowns = 100;

/// Number of instants of growth: so many that assembling the segments of a motion costs little
/// compared with solving them.
constexpr int growth_instants = 401;
constexpr int break_even_instants = 51;

/// Returns a tolerance that rounding allows. Mechanisms of more coordinates reach farther from the
/// origin, where equations are rounded more coarsely. Up to 200 coordinates it is the paper's;
/// beyond, about three times what groups need.
double tolerance_of(int coordinates) { return 5e-15 * std::max(200, coordinates); }

TimeGrid begin_of(const Case& c, int instants) {
  TimeGrid grid = c.with_units(1).grid;
  grid.instants = instants;
  return grid;
}

/// Returns the ids of the global automatic variants whose library is not slow.
std::vector<std::string_view> all_at_once() {
  std::vector<std::string_view> ids;
  for (const Variant& v : variants())
    if (v.partition == Partition::global && v.evaluation == Evaluation::automatic &&
        bench::slow_reason(v).empty())
      ids.push_back(v.id);
  return ids;
}

/// Returns the part of a model that its first `count` entities need; nothing where none of them
/// moves.
std::optional<Model> needed_by_first(const Model& whole, int count) {
  std::vector<Output> outputs;
  for (EntityId e = 0; e < count; ++e)
    if (!whole.is_at_rest(e)) outputs.push_back({e, Level::acceleration});
  if (outputs.empty()) return std::nullopt;
  return make_plan(whole, outputs).model;
}

Model largest(const Case& c) { return make_model(make_scene(c, c.sizes.back())); }

}  // namespace

std::string_view name_of(Question question) {
  return question == Question::growth ? "growth" : "break_even";
}

bench::Problem SizeSeries::problem() const {
  if (question == Question::growth)
    return bench::make_problem(make_model(make_scene(*definition, size)),
                               begin_of(*definition, growth_instants), tolerance_of(size));
  return bench::make_problem(smallest_part(largest(*definition), size),
                             begin_of(*definition, break_even_instants), Settings{}.tolerance);
}

Model smallest_part(const Model& whole, int min_unknowns) {
  const auto counts = std::views::iota(1, static_cast<int>(whole.entities.size()) + 1);
  // More entities never need less.
  const auto enough = std::ranges::partition_point(counts, [&](int count) {
    const std::optional<Model> cut = needed_by_first(whole, count);
    return !cut || bench::moving_unknowns(*cut) < min_unknowns;
  });
  return enough == counts.end() ? whole : *needed_by_first(whole, *enough);
}

std::vector<SizeSeries> make_series(bool quick, const std::regex& filter) {
  std::vector<SizeSeries> all;
  const auto add = [&](Question question, const Case& c, int size, const auto& ids) {
    SizeSeries series{question, &c, size, {}};
    const std::string place = std::string(name_of(question)) + "/";
    for (const std::string_view id : ids) {
      const bench::CandidateName name{std::string(c.name), size, std::string(id)};
      if (std::regex_search(place + name.text(), filter)) series.ids.push_back(id);
    }
    if (!series.ids.empty()) all.push_back(std::move(series));
  };
  for (const Case& c : cases()) {
    for (const int n : coordinates)
      if (!quick || n <= quick_coordinates) add(Question::growth, c, n, growing);
    const Model whole = largest(c);
    int last = 0;  // unknowns of the part before, so that no part is measured twice
    for (const int least : unknowns) {
      if (quick && least > quick_unknowns) break;
      const int found = bench::moving_unknowns(smallest_part(whole, least));
      if (found != last) add(Question::break_even, c, last = found, all_at_once());
    }
  }
  return all;
}

}  // namespace desmo::size
