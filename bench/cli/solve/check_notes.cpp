#include "bench/cli/solve/check_notes.h"

#include <cmath>

#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

namespace {

/// Returns what keeps an instant from being proven; " to prove that a solution is near" follows.
std::string obstacle_text(ProofFailure failure) {
  switch (failure) {
    case ProofFailure::drivers:
      return "rounding of the drivers' values, so large, or an earlier group leaves too few digits";
    case ProofFailure::time:
      return "the drivers' motions, or an earlier group, have too few digits at this time";
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

}  // namespace

std::string off_by(const Misfit& misfit, const Model& m, const DisplayUnits& units) {
  return "'" + m.constraints[misfit.constraint].name + "' is off by " +
         quantity(misfit.amount, misfit.unit(units), "%.1e");
}

std::string flag_text(const RowFlag& f, const Model& m, const DisplayUnits& units) {
  const std::string group = in_group(f.group, m);
  switch (f.kind) {
    case RowFlag::Kind::unproven:
      return group + time_text(f.time) + ": " + obstacle_text(f.failure) +
             " to prove that a solution is near";
    case RowFlag::Kind::branch:
      return group + time_range_text(f.after, f.before) + lost_text(f);
    case RowFlag::Kind::misfit:
      return group + time_text(f.after) + (f.after < f.time ? ", between rows" : "") +
             ": the equations contradict each other: " + off_by(*f.misfit, m, units) +
             "; the motion is that of the others";
    case RowFlag::Kind::crossing:
    case RowFlag::Kind::on_point:
      break;
  }
  if (f.after == f.before)
    return group + time_text(f.time) +
           ": the way from the drawing to the start passes a singular position, where branches "
           "meet, and goes on smoothly";
  if (f.before == INFINITY)
    return group + time_range_text(f.after, f.after) +
           ": from there on it rests on a singular position, where branches meet, or next to it";
  return group + time_range_text(f.after, f.before) +
         ": it passes a singular position, where branches meet, and goes on smoothly";
}

std::string note_on_proofs(const CheckedSummary& s, const CheckOptions& check, const Model& m,
                           const DisplayUnits& units) {
  if (check.mode == CheckMode::none) return "note: nothing is proven (--check none)\n";
  std::string scales;
  for (const Level l : all_levels) {
    if (l > s.level) break;
    scales += (scales.empty() ? "relative to " : ", ") +
              quantity(s.scales.length[l], unit_of(units, EntityKind::point, l), "%.3g") + " or " +
              quantity(s.scales.rotation[l], unit_of(units, EntityKind::angle, l), "%.3g");
  }
  const std::string proven = check.mode != CheckMode::sample || check.sample == 1
                                 ? "rows proven"
                                 : "rows on a proven branch, one in " +
                                       std::to_string(check.sample) + " to the last digit";
  return formatted("accuracy: %ld of %ld ", s.instants - s.flagged, s.instants) + proven + "; " +
         describe_radius(s) + "; " + scales + '\n' + note_on_flags(s, m, units);
}

std::string note_on_flags(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  std::string note;
  if (s.first_flag)
    note += "accuracy: degraded: " + count(s.flagged, "row") + " of " + std::to_string(s.instants) +
            ", the first at " + flag_text(*s.first_flag, m, units) + '\n';
  if (s.first_crossing && !s.first_flag->is_of_change_point())
    note += "accuracy: degraded: " + flag_text(*s.first_crossing, m, units) + '\n';
  if (s.misfit) note += "accuracy: largest contradiction: " + off_by(*s.misfit, m, units) + '\n';
  if (s.crossings > 1)
    note += "accuracy: " + count(s.crossings, "change point") + " flagged in all\n";
  return note;
}

std::string refusal_text(const CheckedSummary& s, const Model& m, const DisplayUnits& units) {
  return flag_text(*s.first_flag, m, units) +
         (s.first_flag->out_of_tests ? "" : "; choose a motion that avoids it") +
         ", or solve without --strict";
}

}  // namespace desmo::cli
