#include "bench/cli/solve/failure_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/cli/solve/check_notes.h"
#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"
#include "formulations/verification/branch/departure.h"

namespace desmo::cli {

namespace {

std::string assembly_error_text(const std::optional<Misfit>& d, const Model& m,
                                const DisplayUnits& units) {
  if (!d || d->constraint < 0 || !std::isfinite(d->amount)) return "";
  return "; at best " + off_by(*d, m, units);
}

/// Reason where Newton's method has failed and no assembly error was found.
constexpr const char* not_reached = "a position exists, but was not found from the one before";

/// Relative residual (<) at which only rounding keeps an instant from its tolerance, so that
/// smaller steps do not help. Compare BasicSummary::residual.
constexpr double near_rounding = 1e-11;

struct Reason {
  std::string what, remedy;
};

/// Returns why the equation of a table is not finite. Only a proof tells that the motion locks at
/// an extremum of the table; without one, a coordinate has left the table.
Reason table_reason(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  if (s.table_lock) {
    const Entity& argument = m.entities[s.table_lock->argument];
    return {"the motion locks: the table has an extremum at " + argument.name + " = " +
                quantity(s.table_lock->at, unit_of(units, argument.kind), "%.6g"),
            "keep the coordinate that follows it within the table's values"};
  }
  return {"a coordinate is outside of its table", "extend the table, or let it repeat"};
}

/// Returns whether a constraint defines the distance of points that coincide in the drawing.
bool measures_no_distance(const Model& m, int constraint) {
  if (constraint < 0) return false;
  const Constraint& c = m.constraints[constraint];
  const std::vector<double> drawn = m.state_of(m.estimate);
  const auto position = [&](EntityId point) {
    return std::span(drawn).subspan(m.state_index(point), m.entities[point].size);
  };
  return constraint_kind_name(c.kind).starts_with("distance") &&
         std::ranges::equal(position(c.operands[0]), position(c.operands[1]));
}

/// Returns why no position was found. is_start: the failed instant is the first, so that no step
/// leads to it.
Reason reason_of(const CheckedSummary& s, const Model& m, const DisplayUnits& units,
                 bool is_start) {
  if (is_start && s.start == FoundStart::Stage::drawing)
    return measures_no_distance(m, s.constraint)
               ? Reason{"the drawing is singular: a distance is measured whose points coincide "
                        "there, so that it has no rate",
                        "draw the points apart, or measure something else, such as a component"}
               : Reason{"the drawing is singular",
                        "draw it off the singular position, such as a dead centre"};
  if (s.status == Status::singular)
    return {"the position is singular", "choose a motion that avoids it"};
  if (s.status == Status::not_finite && s.constraint >= 0 &&
      constraint_kind_name(m.constraints[s.constraint].kind) == "coupling_by_table")
    return table_reason(s, m, units);
  if (s.status != Status::not_converged)
    return {"the equations are not finite", "check the motion and the estimates"};
  if (s.residual < near_rounding)
    return {"the tolerance was not met, being near or below what rounding leaves",
            "ask for a larger tolerance"};
  if (is_start)
    return {s.assembly_error ? "no position was found"
                             : "a position exists, but was not found from the drawing",
            "start nearer to the drawing, or correct it"};
  if (!s.assembly_error) return {not_reached, "take smaller steps, or start elsewhere"};
  return {"no position was found",
          "keep the motion within reach ('desmo range' says how far each driver goes), or take "
          "smaller steps"};
}

}  // namespace

std::string start_text(const Model& m, const DisplayUnits& units, std::span<const double> z) {
  constexpr std::size_t max_named = 3;
  const std::vector<double> magnitudes = nominal_magnitudes(m);
  std::vector<std::pair<double, std::size_t>> away;
  for (std::size_t i = 0; i < m.drivers.size(); ++i) {
    const Entity& e = m.entities[m.drivers[i].coordinate];
    double difference = z[i] - m.estimate[e.first];
    if (e.kind == EntityKind::angle) difference = std::remainder(difference, 2 * std::numbers::pi);
    if (difference != 0) away.emplace_back(-std::abs(difference) / magnitudes[e.first], i);
  }
  std::ranges::stable_sort(away, {}, &std::pair<double, std::size_t>::first);
  if (away.size() > max_named) away.resize(max_named);
  std::string text;
  for (const auto& [distance, i] : away) {
    const Entity& e = m.entities[m.drivers[i].coordinate];
    const DisplayUnit unit = unit_of(units, e.kind);
    text += "; driver '" + e.name + "' starts at " + quantity(z[i], unit, "%.9g") + ", and is at " +
            quantity(m.estimate[e.first], unit, "%.9g") + " in the drawing";
  }
  return text;
}

CheckedSummary failure_of(const Gap& gap, const CheckedSummary& run) {
  CheckedSummary failure;
  static_cast<BasicSummary&>(failure) = gap.failure;
  failure.start = run.start;
  failure.assembly_error = gap.assembly_error;
  failure.table_lock = gap.table_lock;
  return failure;
}

std::string note_on_gaps(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  std::string note;
  for (const Gap& gap : s.gaps)
    note += "accuracy: not assembled: " + in_group(gap.failure.group, m) +
            time_range_text(gap.from, gap.to) + (gap.ends ? "" : ", the end") + ": " +
            (gap.failure.status == Status::singular     ? "the position is singular"
             : gap.failure.status == Status::not_finite ? "the equations are not finite"
             : gap.assembly_error                       ? "no position was found"
                                                        : not_reached) +
            assembly_error_text(gap.assembly_error, m, units) + '\n';
  return note;
}

std::string overflow_text(const std::string& column, double time) {
  return "column '" + column + "', " + time_text(time) +
         ": not a finite number: the motion is faster, or goes further, than double precision "
         "holds; choose another motion";
}

std::string failure_text(const CheckedSummary& s, const Model& m, const DisplayUnits& units,
                         std::span<const double> z) {
  const bool is_start = s.instants == 0;
  const Reason reason = reason_of(s, m, units, is_start);
  std::string place = in_group(s.group, m);
  if (s.constraint >= 0) place += "constraint '" + m.constraints[s.constraint].name + "', ";
  // A residual that is not finite is left out: an interpolated instant that is not right has none.
  const std::string residual =
      std::isfinite(s.residual) ? formatted(" (residual %.1e)", s.residual) : "";
  std::string start = !is_start ? ""
                                : start_text(m, units,
                                             z.empty() ? drivers_at(m, s.time).position
                                                       : std::vector(z.begin(), z.end()));
  if (!start.empty() && z.empty())
    start += " (a motion with \"from\": \"drawing\" counts from there)";
  return place + time_text(s.time) + ": " + reason.what + residual +
         assembly_error_text(s.assembly_error, m, units) + start + "; " + reason.remedy;
}

}  // namespace desmo::cli
