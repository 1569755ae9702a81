#include "tests/properties/judge.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <utility>

#include "formulations/id.h"

namespace desmo::properties {

namespace {

constexpr double unit_roundoff = 0x1p-53;
/// Misfit over κ u from which on no rounding of the numbers in the file explains it. A group has
/// some ten to a hundred of them; bounds on the sum of their effects are some ten times wider.
constexpr double max_explained = 100;
/// Misfit over the largest radius of a coordinate that this radius explains: an equation has up to
/// nine of them.
constexpr double max_slopes = 9;
/// Misfit over u below which one rounding explains it.
constexpr double min_misfit = 0.125;
/// Sizes in a mechanism from which on rounding may decide.
constexpr double max_size_ratio = 1e6;

/// Compares the numbers of a row with the answer; keeps the worst.
class Comparison {
 public:
  explicit Comparison(const DrawnScene& s)
      : s_(s), entity_(entity_of_coordinate(s.plan.model)), asked_(entity_.size()) {
    if (s.plan.outputs.empty()) std::ranges::fill(asked_, std::pair(true, Level::acceleration));
    for (const Output& o : s.plan.outputs) {
      const Entity& e = s.plan.model.entities[o.entity];
      if (e.fixed) continue;
      for (int i = e.first; i < e.first + e.size; ++i)
        asked_[i] = {true, std::max(asked_[i].second, o.level)};
    }
  }

  void compare(const CheckedRow& row, const TrueInstant& truth) {
    for (const Level level : all_levels)
      for (std::size_t i = 0; i < row.values[level].size(); ++i) {
        const auto& [asked, highest] = asked_[i];
        if (!asked || level > highest) continue;
        compare(row, truth, level, i);
      }
  }

  void note(const TrueInstant& t, std::string what, double error = 0) {
    take({std::move(what), {}, Level::position, t.instant.time, error, 0, t.condition}, INFINITY);
  }
  const std::optional<Finding>& worst() const { return worst_; }

 private:
  void compare(const CheckedRow& row, const TrueInstant& truth, Level level, std::size_t i) {
    const Model& m = s_.plan.model;
    const Entity& e = m.entities[entity_[i]];
    const ReferenceInstant& t = truth.instant;
    const double error = error_of(row.values[level][i], t, level, static_cast<int>(i));
    const double radius = row.radius[level].empty() ? INFINITY : row.radius[level][i];
    const double floor = floor_of(s_.truth, truth)[level] * s_.truth.scales.of(e.kind, level);
    const bool has_radius = std::isfinite(radius);
    if (has_radius && error <= radius + floor) return;
    take({has_radius ? "outside its radius" : "without a radius",
          coordinate_name(m, entity_[i], static_cast<int>(i)), level, t.time, error, radius,
          truth.condition},
         has_radius ? error / (radius + floor) : INFINITY);
  }

  void take(Finding finding, double ratio) {
    if (worst_ && !(ratio > ratio_)) return;
    ratio_ = ratio;
    worst_ = std::move(finding);
  }

  const DrawnScene& s_;
  std::vector<EntityId> entity_;
  std::vector<std::pair<bool, Level>>
      asked_;  // is each coordinate requested, and up to which level
  std::optional<Finding> worst_;
  double ratio_ = 0;
};

/// Returns whether a row claims that its numbers are right.
bool claims(const CheckedRow& row) {
  return !row.flag || row.flag->kind == RowFlag::Kind::crossing;
}

bool is_finite(const CheckedRow& row) {
  return std::ranges::all_of(row.values.position, [](double x) { return std::isfinite(x); });
}

/// Returns the largest radius of a row's positions over the mechanism's size, or over one radian; 0
/// where the row has none.
double largest_radius(const Model& m, const CheckedRow& row) {
  if (row.radius.position.empty()) return 0;
  const double size = nominal_size(m);
  double largest = 0;
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && i < e.first + e.size; ++i)
      largest = std::max(largest, row.radius.position[i] / (is_length(e.kind) ? size : 1));
  return largest;
}

bool is_overconstrained(const Model& m) {
  return std::ranges::any_of(m.constraints, [](const Constraint& c) { return c.left_out != 0; });
}

/// Returns whether a row's drivers are where they are to be, and all equations hold, left-out ones
/// included. explained: misfit that says nothing.
bool holds_all(const Model& m, const CheckedRow& row, double time, double explained) {
  const auto motions = motions_of(m)(time);
  for (std::size_t k = 0; k < motions.size(); ++k) {
    const int i = m.entities[m.drivers[k].coordinate].first;
    const Quadruple off = motions[k].position - row.values.position[i];
    if (abs(off) > explained * std::max(1.0, std::abs(row.values.position[i]))) return false;
  }
  return largest_misfit(m, row.values.position, true) <= explained;
}

/// crossed: this row or one before is flagged as passing a change point. Where roundings decide
/// which branch goes on from there, any does, exactly.
void judge_row(Comparison& comparison, const DrawnScene& s, const CheckedRow& row, bool crossed) {
  TrueInstant truth = s.truth.instants[row.index];
  if (crossed && !s.truth.decided[row.index])
    truth = answer_near(s.plan.model, truth.instant.time, row.values.position);
  const double misfit = largest_misfit(s.plan.model, row.values.position);
  const auto explained = [&](double condition) {
    return max_explained * condition * s.truth.far * unit_roundoff +
           max_slopes * largest_radius(s.plan.model, row);
  };
  if (!is_finite(row)) comparison.note(truth, "not finite");
  if (claims(row)) {
    if (is_overconstrained(s.plan.model) && !(truth.condition < undecided)) {
      // Others of the group may be regular where the equations that are kept are not.
      if (!holds_all(s.plan.model, row, truth.instant.time, explained(1)))
        comparison.note(truth, "no answer");
    } else if (!has_answer(truth)) {
      comparison.note(truth, "no answer");
    } else if (misfit > explained(truth.condition) && !(row.flag && row.flag->misfit)) {
      comparison.note(truth, "a contradiction", misfit);
    } else if (largest_misfit(s.plan.model, truth.instant.q) <= explained(truth.condition)) {
      comparison.compare(row, truth);
    }
    // Else the equations that are kept lead to where others fail, past a singular position that
    // all of them together do not have.
  } else if (row.flag->kind == RowFlag::Kind::misfit && has_answer(truth) &&
             misfit < min_misfit * unit_roundoff) {
    comparison.note(truth, "no misfit", misfit);
  }
}

}  // namespace

Judgement judge(const DrawnScene& s, const CheckedRows& run) {
  Judgement j;
  Comparison comparison(s);
  std::vector<const CheckedRow*> row_of(s.scene.grid.instants);
  bool crossed = false;
  for (const CheckedRow& row : run.rows) {
    crossed |= row.flag && row.flag->kind == RowFlag::Kind::crossing;
    judge_row(comparison, s, row, crossed);
    row_of[row.index] = &row;
  }
  j.wrong = comparison.worst();
  for (std::size_t i = 0; i < row_of.size(); ++i) {
    const CheckedRow* const row = row_of[i];
    const bool regular = s.truth.regular[i] && s.truth.size_ratio < max_size_ratio;
    ++j.rows;
    j.regular += regular;
    if (row && !row->flag) continue;
    const std::string word(row ? word_of(*row->flag) : "missing");
    ++j.flags[word];
    if (!regular || word == "misfit") continue;  // a misfit was judged above
    ++j.regular_flags[word];
    if (!row || j.first_regular_flag) continue;
    j.first_regular_flag = row->flag;
    j.condition = s.truth.instants[i].path_condition;
  }
  return j;
}

std::optional<CheckedRows> solve_checked(const DrawnScene& s, const std::string& id) {
  std::unique_ptr<Formulation> f;
  try {
    const Configuration c = parse_id(id, {.tolerance = s.scene.tolerance});
    f = make_formulation(*c.variant, s.plan.model, c.settings);
  } catch (const std::invalid_argument&) {
    return std::nullopt;
  }
  return desmo::solve_checked(*f, s.scene.grid, s.plan.level(),
                              {.mode = s.mode, .levels = s.plan.levels});
}

}  // namespace desmo::properties
