#include "bench/cli/solve/check_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

namespace {

std::string moment(double time) { return formatted("t = %.9g s", time); }

/// Returns "t = 1 s to 2 s"; one moment where both are the same in print.
std::string interval(double from, double to) {
  const std::string first = formatted("%.12g s", from), last = formatted("%.12g s", to);
  return "t = " + (first == last ? first : first + " to " + last);
}

std::string group_text(GroupId group, const Model& m) {
  if (group < 0) return "";
  return "group '" + m.groups[group].name + "' (" + enumerate(m.groups[group].bodies, 8) + "), ";
}

std::string off_by(int constraint, double amount, bool is_length, const Model& m,
                   const DisplayUnits& units) {
  const DisplayUnit unit = is_length ? units.length : DisplayUnit{"1"};
  return "'" + m.constraints[constraint].name + "' is off by " + quantity(amount, unit, "%.1e");
}

std::string assembly_error_text(const std::optional<AssemblyError>& d, const Model& m,
                                const DisplayUnits& units) {
  if (!d || d->constraint < 0 || !std::isfinite(d->amount)) return "";
  return "; at the nearest to it " + off_by(d->constraint, d->amount, d->is_length, m, units);
}

/// Returns what keeps an instant from being proven.
std::string obstacle_text(ProofFailure failure) {
  switch (failure) {
    case ProofFailure::drivers:
      return "rounding of the drivers' values, so large, leaves too few digits";
    case ProofFailure::time:
      return "the drivers' motions have too few digits at this time";
    case ProofFailure::origin:
      return "rounding of the coordinates, so far from the origin, leaves too few digits";
    case ProofFailure::sizes:
      return "rounding, with lengths of so different sizes, leaves too few digits";
    case ProofFailure::far_off:
      return "the position is too far off";
    case ProofFailure::singular:
    case ProofFailure::none:
      break;
  }
  return "the position is too near a singular one";
}

/// Returns why the branch of a row is not known.
std::string lost_text(const RowFlag& f) {
  const bool is_start = f.after == f.before;
  if (f.out_of_tests)
    return is_start ? ": the budget of tests ended on the way from the drawing to the start; which "
                      "branch it leads to is not known; draw it nearer to the start"
                    : ": the budget of tests of a step ended before the motion was followed; which "
                      "branch it continues on is not known; take smaller steps";
  return is_start ? ": the way from the drawing to the start is blocked by a singular position; "
                    "which branch it leads to is not known"
                  : ": the motion cannot be followed past a singular position; which branch it "
                    "continues on is not known";
}

/// Newton's method has failed, and there is no assembly error.
constexpr const char* not_reached = "a position exists, but was not found from the one before";

/// A residual below which a position is found but for rounding: no step, however small, helps.
constexpr double near_rounding = 1e-11;

struct Reason {
  std::string what, remedy;
};

/// Returns why a table is of no help. Without a proof, nobody knows which way led out of it.
Reason table_reason(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  if (s.table_lock) {
    const Entity& argument = m.entities[s.table_lock->argument];
    return {"the motion locks: the table has an extremum at " + argument.name + " = " +
                quantity(s.table_lock->at, unit_of(units, argument.kind), "%.6g"),
            "keep the coordinate that follows it within the table's values"};
  }
  return {"a coordinate is outside of its table", "extend the table, or let it repeat"};
}

/// Returns why no position was found. is_start: the failed instant is the first, so that no step
/// leads to it.
Reason reason_of(const CheckedSummary& s, const Model& m, const DisplayUnits& units,
                 bool is_start) {
  if (is_start && s.start == FoundStart::Stage::drawing)
    return {"the drawing is singular", "draw it off the singular position, such as a dead centre"};
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

std::string flag_text(const RowFlag& f, const Model& m, const DisplayUnits& units) {
  const std::string group = group_text(f.group, m);
  switch (f.kind) {
    case RowFlag::Kind::unproven:
      return group + moment(f.time) + ": " + obstacle_text(f.failure) +
             " to prove that a solution is near";
    case RowFlag::Kind::branch:
      return group + interval(f.after, f.before) + lost_text(f);
    case RowFlag::Kind::misfit:
      return group + moment(f.after) + (f.after < f.time ? ", between rows" : "") +
             ": the equations contradict each other: " +
             off_by(f.misfit->constraint, f.misfit->amount, f.misfit->is_length, m, units) +
             "; the motion is that of the others";
    case RowFlag::Kind::crossing:
    case RowFlag::Kind::on_point:
      break;
  }
  if (f.after == f.before)
    return group + moment(f.time) +
           ": the way from the drawing to the start passes a singular position, where branches "
           "meet, and goes on smoothly";
  if (f.before == INFINITY)
    return group + interval(f.after, f.after) +
           ": from there on it rests on a singular position, where branches meet, or next to it";
  return group + interval(f.after, f.before) +
         ": it passes a singular position, where branches meet, and goes on smoothly";
}

std::string note_on_proofs(const CheckedSummary& s, const CheckOptions& check, Level level,
                           const Model& m, const DisplayUnits& units) {
  if (check.mode == CheckMode::none) return "note: nothing is proven (--check none)\n";
  std::string scales;
  for (const Level l : all_levels) {
    if (l > level) break;
    scales += (scales.empty() ? "relative to " : ", ") +
              quantity(s.scales.length[l], unit_of(units, EntityKind::point, l), "%.3g") + " or " +
              quantity(s.scales.rotation[l], unit_of(units, EntityKind::angle, l), "%.3g");
  }
  const std::string proven = check.mode != CheckMode::sample || check.sample == 1
                                 ? "rows proven"
                                 : "rows on a proven branch, one in " +
                                       std::to_string(check.sample) + " to the last digit";
  return formatted("accuracy: %ld of %ld ", s.instants - s.flagged, s.instants) + proven + "; " +
         describe_radius(s, level) + "; " + scales + '\n' + note_on_flags(s, m, units);
}

std::string note_on_flags(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  std::string note;
  if (s.first_flag)
    note += "accuracy: degraded: " + count(s.flagged, "row") + " of " + std::to_string(s.instants) +
            ", the first at " + flag_text(*s.first_flag, m, units) + '\n';
  if (s.first_crossing && s.first_crossing->time != s.first_flag->time)
    note += "accuracy: degraded: " + flag_text(*s.first_crossing, m, units) + '\n';
  if (s.misfit)
    note += "accuracy: largest contradiction: " +
            off_by(s.misfit->constraint, s.misfit->amount, s.misfit->is_length, m, units) + '\n';
  if (s.crossings > 1) note += "accuracy: " + count(s.crossings, "change point") + " met in all\n";
  return note;
}

std::vector<double> driver_values(const Model& m, double time) {
  std::vector<double> z;
  for (const Driver& driver : m.drivers) z.push_back(sample(driver.motion, time).position);
  return z;
}

std::string start_text(const Model& m, const DisplayUnits& units, std::span<const double> z) {
  constexpr std::size_t most = 3;
  const std::vector<double> magnitudes = nominal_magnitudes(m);
  std::vector<std::pair<double, std::size_t>> away;
  for (std::size_t i = 0; i < m.drivers.size(); ++i) {
    const Entity& e = m.entities[m.drivers[i].coordinate];
    double difference = z[i] - m.estimate[e.first];
    if (e.kind == EntityKind::angle) difference = std::remainder(difference, 2 * std::numbers::pi);
    if (difference != 0) away.emplace_back(-std::abs(difference) / magnitudes[e.first], i);
  }
  std::ranges::stable_sort(away, {}, &std::pair<double, std::size_t>::first);
  if (away.size() > most) away.resize(most);
  std::string text;
  for (const auto& [distance, i] : away) {
    const Entity& e = m.entities[m.drivers[i].coordinate];
    const DisplayUnit unit = unit_of(units, e.kind);
    text += "; driver '" + e.name + "' starts at " + quantity(z[i], unit, "%.9g") + ", and is at " +
            quantity(m.estimate[e.first], unit, "%.9g") + " in the drawing";
  }
  return text;
}

std::string note_on_gaps(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  std::string note;
  for (const Gap& gap : s.gaps)
    note += "accuracy: not assembled: " + group_text(gap.failure.group, m) +
            interval(gap.from, gap.to) + (gap.ends ? "" : ", the end") + ": " +
            (gap.failure.status == Status::singular     ? "the position is singular"
             : gap.failure.status == Status::not_finite ? "the equations are not finite"
             : gap.assembly_error                       ? "no position was found"
                                                        : not_reached) +
            assembly_error_text(gap.assembly_error, m, units) + '\n';
  return note;
}

std::string refusal_text(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  return flag_text(*s.first_flag, m, units) +
         (s.first_flag->out_of_tests ? "" : "; choose a motion that avoids it") +
         ", or solve without --strict";
}

std::string overflow_text(const std::string& column, double time) {
  return "column '" + column + "', " + moment(time) +
         ": not a finite number: the motion is faster, or goes further, than double precision "
         "holds; choose another motion";
}

std::string failure_text(const CheckedSummary& s, const Model& m, const DisplayUnits& units,
                         std::span<const double> z) {
  const bool is_start = s.instants == 0;
  const Reason reason = reason_of(s, m, units, is_start);
  std::string place = group_text(s.group, m);
  if (s.constraint >= 0) place += "constraint '" + m.constraints[s.constraint].name + "', ";
  // There is none where an instant between those solved is not right.
  const std::string residual =
      std::isfinite(s.residual) ? formatted(" (residual %.1e)", s.residual) : "";
  std::string start = !is_start ? ""
                                : start_text(m, units,
                                             z.empty() ? driver_values(m, s.time)
                                                       : std::vector(z.begin(), z.end()));
  if (!start.empty() && z.empty())
    start += " (a motion with \"from\": \"drawing\" counts from there)";
  return place + moment(s.time) + ": " + reason.what + residual +
         assembly_error_text(s.assembly_error, m, units) + start + "; " + reason.remedy;
}

}  // namespace desmo::cli
