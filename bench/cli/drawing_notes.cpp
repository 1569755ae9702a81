#include "bench/cli/drawing_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "formulations/constraints/coordinates.h"
#include "formulations/constraints/table.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/equations/candidates.h"

namespace desmo::cli {
namespace {

/// Largest offset (≤) that counts as 0, divided by the equation's characteristic length.
constexpr double max_meant_as_zero = 1e-9;

/// Largest difference (≤) between a table's value and the drawing that counts as none: [rad], or a
/// length divided by the equation's characteristic length. Drawings have some six digits.
constexpr double max_difference = 1e-6;

std::string note_on_offset(const Mechanism& mechanism, const Mechanism::Joint& j, const Model& m,
                           const DisplayUnits& units) {
  const bool has_normal = j.type == Mechanism::JointType::point_on_plane;
  if (!has_normal && j.type != Mechanism::JointType::revolute_on_slider) return "";
  const std::string name =
      j.name + std::string(has_normal ? plane_distance_equation : offset_equation);
  const auto kept = std::ranges::find(m.constraints, name, &Constraint::name);
  if (kept == m.constraints.end()) return "";
  const double offset = std::abs(kept->constants[0].value);
  if (offset <= max_meant_as_zero * CharacteristicLengths(m).of(*kept)) return "";
  return "note: " + j.name + ": " + mechanism.points[j.points[1]].name + " is drawn " +
         quantity(offset, units.length, "%.3g") + " off the " + (has_normal ? "plane" : "line") +
         " through " + mechanism.points[j.points[0]].name +
         (has_normal ? " with the normal '" : " along '") + mechanism.vectors[j.vectors[0]].name +
         "', and stays there\n";
}

/// c: the equation of a coupling by a table f, s₁ = b + u f(k s₂). Its operands are s₁ and s₂, its
/// numbers 0 to 2 are u, k and b.
std::string note_on_table(const Constraint& c, const Model& m, const DisplayUnits& units) {
  const Entity &first = m.entities[c.operands[0]], &second = m.entities[c.operands[1]];
  const auto number = [&c](int k) { return c.constants[k].value; };
  const auto table = [&number](int k) { return number(TableCoupling::table + k); };
  const double drawn = m.estimate[first.first];
  const double given =
      number(2) + number(0) * table_number<0>(table, number(1) * m.estimate[second.first]);
  const bool is_of_length = is_length(first.kind);
  const double off = is_of_length ? (given - drawn) / CharacteristicLengths(m).of(c)
                                  : std::remainder(given - drawn, 2 * std::numbers::pi);
  if (std::abs(off) <= max_difference) return "";
  const DisplayUnit unit = unit_of(units, first.kind);
  return "note: coupling '" + c.name.substr(0, c.name.rfind(':')) + "': its table gives " +
         first.name + " = " + quantity(given, unit, "%.6g") + " where " + second.name +
         " is drawn, " + first.name + " is drawn at " + quantity(drawn, unit, "%.6g") +
         "; where the table is a lift, add \"from\": \"drawing\"\n";
}

}  // namespace

std::string note_on_drawing(const Mechanism& mechanism, const Model& m, const DisplayUnits& units) {
  std::string notes;
  for (const Mechanism::Joint& j : mechanism.joints)
    notes += note_on_offset(mechanism, j, m, units);
  // Where a body has a frame or a length of its own, the drawing is an estimate: a table that
  // contradicts it may be meant.
  if (std::ranges::any_of(mechanism.bodies,
                          [](const auto& body) { return body.own || body.length; }))
    return notes;
  for (const Constraint& c : m.constraints)
    if (constraint_kind_name(c.kind) == TableCoupling::name) notes += note_on_table(c, m, units);
  return notes;
}

}  // namespace desmo::cli
