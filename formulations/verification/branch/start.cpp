#include "formulations/verification/branch/start.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "cases/numbers/compensated.h"
#include "formulations/model/misfit.h"
#include "formulations/model/whole_turns.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/continuation.h"
#include "formulations/verification/branch/passage.h"

namespace desmo {

namespace {

using Stage = FoundStart::Stage;
constexpr double turn = 2 * std::numbers::pi;

/// Turns the equations of a model into Newton's homotopy from the drawing: Φ₀ = Φ(drawing).
void begin_at_drawing(Model& m) {
  const std::vector<double> state = m.state_of(m.estimate);
  for (Constraint& c : m.constraints) c.initial_residual = residual_of(m, c, state);
}

/// Returns the motion that is `from` at 0 and, but for whole turns that are left out, motion(time)
/// at 1.
Polynomial straight(double from, const Motion& motion, double time, double left_out_turns) {
  using Number = Compensated<double>;
  const Number way = sample(motion, Number(time)).position - Number(from);
  return {{from, {std::fma(-left_out_turns, turn, way.value), {way.correction, way.radius}}}};
}

/// Passes the change point on which the motion begins, if the drivers' way from the drawing ends at
/// one. Writes found.point.
/// - going: the model with its drivers on that way, which is proven up to found.share
void pass_at_start(const Model& m, const Model& going, double time, FoundStart& found) {
  std::vector<double> direction;
  for (const Driver& d : going.drivers) direction.push_back(sample(d.motion, found.share).velocity);
  TestBudget budget(BranchPath::max_tests);
  if (auto point =
          pass_change_point(m, {0, {found.q, {}, {}}, {}}, direction, time, found.group, budget))
    found.point = std::make_shared<PassedPoint>(std::move(*point));
}

/// Whole turns of each driver, and those that each coordinate makes with them.
struct Turns {
  std::vector<double> of_drivers, of_coordinates;
};

/// Returns the turns that each driver makes from the drawing to a time [s]; 0 for distances.
std::vector<double> turns_to(const Model& m, double time) {
  std::vector<double> turns;
  for (const Driver& d : m.drivers) {
    const Entity& e = m.entities[d.coordinate];
    const double way = sample(d.motion, time).position - m.estimate[e.first];
    turns.push_back(e.kind == EntityKind::angle ? way / turn : 0);
  }
  return turns;
}

/// Returns whether way × u > 1 rad for a driven angle, with u = 2⁻⁵³. A step of a radian is then
/// lost in the rounding of the time 1, and a path would be stuck at every step.
bool is_lost_in_rounding(const Model& going) {
  return std::ranges::any_of(going.drivers, [&](const Driver& d) {
    const double way = sample(d.motion, 0.).velocity;
    return going.entities[d.coordinate].kind == EntityKind::angle &&
           std::abs(way) * Interval::unit > 1;
  });
}

/// Moves the drivers from the drawing to their values at a time [s], then adds the turns that were
/// left out on the way. Returns whether the way is proven.
bool continue_drivers(const Model& m, double time, const Turns& left_out, FoundStart& found) {
  Model going = m;
  for (std::size_t d = 0; d < m.drivers.size(); ++d) {
    Motion& motion = going.drivers[d].motion;
    const double from = m.estimate[m.entities[m.drivers[d].coordinate].first];
    motion = straight(from, motion, time, left_out.of_drivers[d]);
  }
  if (is_lost_in_rounding(going)) {
    found.out_of_tests = true;
    found.share = 0;
    return false;
  }
  if (!follow_continuation(going, true, found)) {
    if (!found.out_of_tests) pass_at_start(m, going, time, found);
    return false;
  }
  for (int i = 0; i < m.coordinates(); ++i) found.q[i] += turn * left_out.of_coordinates[i];
  for (const Driver& d : m.drivers)
    found.q[m.entities[d.coordinate].first] = sample(d.motion, time).position;
  return true;
}

/// Changes free angles by whole turns, to within half a turn of the drawing.
void take_nearest_turns(const Model& m, FoundStart& found) {
  for (const int i : free_angles(m)) {
    const double turns = turn * std::round((found.q[i] - m.estimate[i]) / turn);
    found.q[i] -= turns;
    if (!found.point) continue;
    found.point->polynomials[i].front() -= turns;
    if (std::vector<double>& q = found.point->first.values.position; !q.empty()) q[i] -= turns;
  }
}

/// Returns whether one turn of some drivers leads back to where it begins; then further turns do,
/// too. Adds the whole turns that coordinates make in all of them.
/// - signs: direction of each driver's turn, 1 or −1; 0: it rests
/// - count: number of turns that each of these drivers makes in all
bool add_turns(const Model& m, const std::vector<double>& signs, double count,
               const FoundStart& nominal, std::vector<double>& of_coordinates) {
  Model going = m;
  for (std::size_t d = 0; d < signs.size(); ++d)
    going.drivers[d].motion =
        Polynomial{{m.estimate[m.entities[m.drivers[d].coordinate].first], signs[d] * turn}};
  FoundStart found = nominal;
  BranchPath first(going);
  const std::span<const double> from = first.start_at({0, {nominal.q, {}, {}}})
                                           ? first.present().values.position
                                           : std::span<const double>(nominal.q);
  if (!follow_continuation(going, true, found) || !is_back(m, from, found.q)) return false;
  for (const Entity& e : m.entities)
    if (!e.fixed && e.kind == EntityKind::angle)
      of_coordinates[e.first] += count * std::round((found.q[e.first] - from[e.first]) / turn);
  return true;
}

/// Returns the whole turns that drivers make up to a time, if these lead back to where they begin.
/// Turns of all drivers at once are tried if all have the same number, else those of each driver by
/// itself.
std::optional<Turns> turns_that_lead_back(const Model& m, double time, const FoundStart& nominal) {
  Turns all{turns_to(m, time), std::vector<double>(m.coordinates())};
  std::vector<double> signs(m.drivers.size());
  double most = 0;
  bool are_equal = true;
  for (std::size_t d = 0; d < signs.size(); ++d) {
    const double turns = all.of_drivers[d] = std::trunc(all.of_drivers[d]);
    if (turns == 0) continue;
    signs[d] = turns < 0 ? -1 : 1;
    are_equal &= most == 0 || most == std::abs(turns);
    most = std::max(most, std::abs(turns));
  }
  if (!(most > 0 && most < INFINITY)) return {};
  for (std::size_t d = 0; d < signs.size(); ++d) {
    if (signs[d] == 0) continue;
    std::vector<double> own(signs.size());
    own[d] = signs[d];
    if (!add_turns(m, are_equal ? signs : own, std::abs(all.of_drivers[d]), nominal,
                   all.of_coordinates))
      return {};
    if (are_equal) break;
  }
  return all;
}

/// Returns whether a path may have too few tests for a driver's turns: way > max_tests / 6 turns.
/// In loops, a step is hardly longer than a radian, a sixth of a turn.
bool has_too_many_turns(const Model& m, double time) {
  constexpr double max_turns = BranchPath::max_tests / 6.;
  return std::ranges::any_of(turns_to(m, time), [](double x) { return std::abs(x) > max_turns; });
}

}  // namespace

FoundStart find_start(const Model& m, double time) {
  FoundStart found{.q = m.estimate};
  Model at_drawing = m;
  for (Driver& d : at_drawing.drivers)
    d.motion = Polynomial{{m.estimate[m.entities[d.coordinate].first]}};
  // If the drawing has a certificate, no homotopy is needed: the same test proves all of it. For
  // each λ ≤ 1 its image is that of the certificate with λ times the centre. It is inside X, too,
  // since X is symmetric about the drawing.
  const Certificate drawing = Certifier(at_drawing).certify({0, 0, found.q, {}, {}});
  if (!drawing.proven) {
    found.group = drawing.group;
    begin_at_drawing(at_drawing);
    if (!follow_continuation(at_drawing, false, found)) {
      found.stage = Stage::drawing;
      return found;
    }
  }
  const FoundStart nominal = found;
  const bool are_many = has_too_many_turns(m, time);
  const Turns none{std::vector<double>(m.drivers.size()), std::vector<double>(m.coordinates())};
  std::optional<Turns> left_out;
  if (are_many) left_out = turns_that_lead_back(m, time, nominal);
  bool is_reached = continue_drivers(m, time, left_out.value_or(none), found);
  if (!are_many && found.out_of_tests) {
    left_out = turns_that_lead_back(m, time, nominal);
    if (left_out) {
      found = nominal;
      is_reached = continue_drivers(m, time, *left_out, found);
    }
  }
  if (!is_reached) found.stage = Stage::drivers;
  take_nearest_turns(m, found);
  return found;
}

}  // namespace desmo
