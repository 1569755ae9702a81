#include "bench/cli/solve/run_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "bench/cli/inspect/inspection.h"
#include "bench/cli/text.h"
#include "bench/cli/units.h"
#include "bench/kit/problem.h"
#include "cases/mechanism/formatted.h"
#include "formulations/scaling/scales.h"
#include "formulations/stepping/formulation_core.h"
#include "formulations/structure/partition.h"

namespace desmo::cli {

namespace {

std::string moment(double time) { return formatted("t = %.9g s", time); }

/// "t = 1 s to 2 s"; one moment where both are the same in print.
std::string interval(double from, double to) {
  const std::string first = formatted("%.12g s", from), last = formatted("%.12g s", to);
  return "t = " + (first == last ? first : first + " to " + last);
}

std::string group_text(GroupId group, const Model& m) {
  if (group < 0) return "";
  return "group '" + m.groups[group].name + "' (" + enumerate(m.groups[group].bodies, 8) + "), ";
}

const char* limit_text(Limit limit) {
  switch (limit) {
    case Limit::singular_position:
      return "so near a singular position that ";
    case Limit::drivers:
      return "rounding of the drivers, so late or after so many turns: ";
    case Limit::origin:
      return "rounding of the coordinates, so far from the origin: ";
    case Limit::sizes:
      return "rounding, with lengths of so different sizes: ";
    case Limit::rounding:
      break;
  }
  return "rounding, which is more than the tolerance allows: ";
}

/// Returns what rounding leaves no digit of, and what to do.
std::string rounding_text(Limit limit) {
  return limit == Limit::drivers
             ? "rounding of the drivers' values, so large, leaves too few digits; choose a slower "
               "motion, or earlier times"
         : limit == Limit::origin
             ? "rounding of the coordinates, so far from the origin, leaves too few digits; place "
               "the mechanism nearer to it"
             : "rounding, with lengths of so different sizes, leaves too few digits; let them "
               "differ less";
}

std::string assembly_error_text(const std::optional<AssemblyError>& d, const Model& m,
                                const DisplayUnits& units) {
  if (!d || d->constraint < 0) return "";
  const DisplayUnit unit = d->is_length ? units.length : DisplayUnit{"1"};
  return "; at the nearest to it '" + m.constraints[d->constraint].name + "' is off by " +
         quantity(d->amount, unit, "%.1e");
}

/// Newton's method has failed, and there is no assembly error.
constexpr const char* not_reached = "a position exists, but was not found from the one before";

/// A residual below which a position is found but for rounding: no step, however small, helps.
constexpr double near_rounding = 1e-11;

struct Reason {
  std::string what, remedy;
};

/// Returns why no position was found. is_start: the failed instant is the first, so that no step
/// leads to it.
Reason reason_of(const MonitoredSummary& s, bool is_start) {
  if (s.status == Status::singular)
    return {"the position is singular", "choose a motion that avoids it"};
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

/// Returns "constraint 'theta: definition', t = 0.3 s: solved on another branch …; <remedy>".
std::string branch_text(int constraint, double time, const Model& m) {
  return "constraint '" + m.constraints[constraint].name + "', " + moment(time) +
         ": solved on another branch than the one it means, such as an angle turns away, or where "
         "constraints left out do not follow from the others; take smaller time steps, or model it "
         "in another way";
}

constexpr std::size_t names_shown = 8;

std::string fraction(int kept, int all, const std::string& noun) {
  return std::to_string(kept) + " of " + count(all, noun);
}

std::string use_text(const Plan::GroupUse& use) {
  std::string text = use.name + ": keeps " + fraction(use.kept_unknowns, use.unknowns, "unknown") +
                     " in " + fraction(use.kept_blocks, use.blocks, "block") + ", to " +
                     bench::level_names[use.level];
  if (!use.serves.empty()) text += "; serves " + use.serves;
  text += "; kept: " + enumerate(use.kept, names_shown);
  if (!use.dropped.empty()) text += "; dropped: " + enumerate(use.dropped, names_shown);
  return text;
}

std::vector<std::string> drivers_not_needed(const Plan& plan, const Model& whole) {
  const std::vector<std::string> kept = driver_names(plan.model);
  std::vector<std::string> names = driver_names(whole);
  std::erase_if(names, [&](const std::string& name) { return std::ranges::count(kept, name) > 0; });
  return names;
}

}  // namespace

std::string explain(const Plan& plan, const Model& whole) {
  int kept = 0, all = 0;
  std::string groups;
  std::vector<std::string> not_needed;
  for (const Plan::GroupUse& use : plan.groups) {
    kept += use.kept_unknowns;
    all += use.unknowns;
    if (use.kept.empty())
      not_needed.push_back(use.name);
    else
      groups += "  " + wrap(use_text(use), 4) + "\n";
  }
  if (!not_needed.empty())
    groups += "  " + wrap("groups not needed: " + enumerate(not_needed, names_shown), 4) + "\n";
  std::string text =
      "solved: " + fraction(kept, all, "unknown") + ", " +
      fraction(plan.model.degrees_of_freedom(), whole.degrees_of_freedom(), "driver") + "\n" +
      groups;
  if (const auto unused = drivers_not_needed(plan, whole); !unused.empty())
    text += "  " + wrap("drivers not needed: " + enumerate(unused, names_shown), 4) + "\n";
  return text;
}

std::string degradation_text(const Degradation& d, Level level, const Model& m) {
  return group_text(d.assessment.group, m) + moment(d.time) + ": " +
         limit_text(d.assessment.limit) +
         describe_accuracy(d.assessment.condition, d.assessment.bound, level);
}

std::string crossing_text(const SingularityCrossing& c, const Model& m) {
  const std::string group = group_text(c.group, m);
  if (c.kind == SingularityCrossing::Kind::not_declared)
    return group + moment(c.before) +
           ": assembled on another branch than the one that its estimate declares";
  return group + interval(c.after, c.before) + ": " +
         (c.kind == SingularityCrossing::Kind::jumped
              ? "the motion jumps onto another assembly branch"
              : "it passes a singular position, where branches meet");
}

std::string note_on_code(const Formulation& f, bool named) {
  const auto without = std::ranges::count(parts_of(f), false, &DefinedPart::as_named);
  if (without == 0) return "";
  return "note: no generated code for " + std::to_string(without) + " of " +
         count(static_cast<long>(parts_of(f).size()), "part") +
         (without == 1 ? "; it is evaluated automatically" : "; they are evaluated automatically") +
         (named ? "\n" : " (a formulation that is named, with --formulation, has it made)\n");
}

std::string note_on_tolerance(const Formulation& f, double asked) {
  if (f.tolerance() < 1.01 * asked) return "";
  return formatted(
      "note: the tolerance %.2g is below what rounding leaves; positions were solved to %.2g\n",
      asked, f.tolerance());
}

std::string note_on_refusals(const Formulation& f, bool named) {
  const auto [refactorisations, steps, changes] = part_counts(f);
  long parts = 0;
  for (const DefinedPart& part : parts_of(f)) parts += part.solver->counts().fallbacks > 0;
  if (steps == 0) return "";
  std::string note = "note: generated code left " + count(steps, "step") + " of " +
                     count(parts, "part") +
                     " to a more general solver, some 10 times slower; the numbers are as exact";
  if (changes > 0)
    note += "; " + std::to_string(changes) + " of them on another assembly branch than before";
  if (!named) note += " (a formulation that is named, with --formulation, has better code made)";
  return note + "\n";
}

std::string note_on_steps(const Formulation& f) {
  if (core_of(f).runs_without_segments() == 0) return "";
  return "note: solved step by step, for the motion is short or could not be solved in segments\n";
}

std::string note_on_stride(const MonitoredSummary& s, const Formulation& f) {
  if (s.shortest_stride == 0) return "";
  return "note: in places a stride of " + std::to_string(f.settings().stride) +
         " is too long for the tolerance; it was halved, down to " +
         std::to_string(s.shortest_stride) + "\n";
}

std::string note_on_accuracy(const MonitoredSummary& s, Level level, const Model& m,
                             const DisplayUnits& units) {
  std::string scales;
  for (const Level l : all_levels) {
    if (l > level) break;
    scales += (scales.empty() ? "relative to " : ", ") +
              quantity(s.scales.length[l], unit_of(units, EntityKind::point, l), "%.3g") + " or " +
              quantity(s.scales.rotation[l], unit_of(units, EntityKind::angle, l), "%.3g");
  }
  return "accuracy: " + describe_accuracy(s.condition, s.bound, level) + "; " + scales + '\n' +
         note_on_flags(s, level, m);
}

std::string note_on_flags(const MonitoredSummary& s, Level level, const Model& m) {
  std::string note;
  if (s.first_degraded)
    note += "accuracy: degraded: " + count(s.degraded, "instant") + " of " +
            std::to_string(s.instants) + ", the first at " +
            degradation_text(*s.first_degraded, level, m) + '\n';
  if (s.crossing)
    note += "accuracy: degraded: " + crossing_text(*s.crossing, m) +
            (s.limit ? ", or rounding makes it look so" : "") + '\n';
  return note;
}

std::string_view flag_of(const MonitoredInstant& i) {
  if (!i.crossing) return i.degraded ? "degraded" : "";
  return i.crossing->kind == SingularityCrossing::Kind::passed ? "crossing" : "branch";
}

std::vector<double> driver_values(const Model& m, double time) {
  std::vector<double> z;
  for (const Driver& driver : m.drivers) z.push_back(sample(driver.motion, time).position);
  return z;
}

std::string start_text(const Model& m, const DisplayUnits& units, std::span<const double> z) {
  constexpr std::size_t most = 3;
  const std::vector<double> magnitudes = natural_magnitudes(m);
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

std::string note_on_gaps(const MonitoredSummary& s, const Model& m, const DisplayUnits& units) {
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

std::string refusal_text(const MonitoredSummary& s, Level level, const Model& m) {
  return (s.first_degraded ? degradation_text(*s.first_degraded, level, m)
                           : crossing_text(*s.crossing, m)) +
         "; choose a motion that avoids it, or solve without --strict";
}

std::string overflow_text(const std::string& column, double time) {
  return "column '" + column + "', " + moment(time) +
         ": not a finite number: the motion is faster, or goes further, than double precision "
         "holds; choose another motion";
}

std::string failure_text(const MonitoredSummary& s, const Model& m, const DisplayUnits& units,
                         std::span<const double> z) {
  if (s.limit)
    return group_text(s.group, m) + moment(s.time) +
           ": no position can be told: " + rounding_text(*s.limit);
  if (s.violated >= 0) return branch_text(s.violated, s.time, m);
  const bool is_start = s.instants == 0;
  const Reason reason = reason_of(s, is_start);
  std::string place = group_text(s.group, m);
  if (s.constraint >= 0) place += "constraint '" + m.constraints[s.constraint].name + "', ";
  // There is none where an instant between those solved is not right.
  const std::string residual =
      std::isfinite(s.residual) ? formatted(" (residual %.1e)", s.residual) : "";
  const std::string start = !is_start ? ""
                                      : start_text(m, units,
                                                   z.empty() ? driver_values(m, s.time)
                                                             : std::vector(z.begin(), z.end()));
  return place + moment(s.time) + ": " + reason.what + residual +
         assembly_error_text(s.assembly_error, m, units) + start + "; " + reason.remedy;
}

}  // namespace desmo::cli
