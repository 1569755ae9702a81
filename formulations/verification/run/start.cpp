#include "formulations/verification/run/start.h"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "cases/numbers/compensated.h"
#include "formulations/constraints/constraints.h"
#include "formulations/verification/run/branch_path.h"
#include "formulations/verification/run/passage.h"

namespace desmo {

namespace {

using Stage = FoundStart::Stage;
constexpr double turn = 2 * std::numbers::pi;

/// Returns Φ of the drawing.
std::vector<std::vector<double>> residual_of_drawing(const Model& m) {
  std::vector<double> state = m.estimate;
  state.insert(state.end(), m.fixed_values.begin(), m.fixed_values.end());
  std::vector<std::vector<double>> all;
  for (const Constraint& c : m.constraints)
    visit_kind(c.kind, [&]<class Kind>(Kind) {
      std::array<const double*, Kind::operand_sizes.size()> x;
      for (std::size_t k = 0; k < x.size(); ++k) x[k] = state.data() + m.state_index(c.operands[k]);
      std::vector<double> phi(Kind::rows);
      Kind::residual(x.data(), c.constants.data(), phi.data());
      all.push_back(std::move(phi));
    });
  return all;
}

/// Returns the motion from a value, at 0, to that of another motion at a time, at 1. turn: whole
/// ones of it are left out.
Polynomial straight(double from, const Motion& motion, double time, double turn) {
  using Number = Compensated<double>;
  const Number way = sample(motion, Number(time)).position - Number(from);
  const double short_way = std::remainder(way.value, turn);
  return {{from, short_way}, {{}, {way.correction, way.radius}}};
}

/// Follows a way from 0 to 1. found: begins at its positions, which are overwritten by the last
/// proven ones.
FollowedStep follow(const Model& m, InitialResidual initial, bool may_pass, FoundStart& found) {
  BranchPath path(m, BranchPath::max_tests, initial);
  found.share = 0;
  if (!path.start_at({0, {found.q, {}, {}}})) return {};
  FollowedStep step = path.go_to(1);
  int tests = step.tests;
  while (may_pass && step.end == PathEnd::stuck && tests < BranchPath::max_tests) {
    const std::optional<PassedPoint> point = pass_change_point(m, path.present());
    if (!point || !(point->before < 1) || !path.start_at(point->beyond())) break;
    found.passed.push_back(point->time);
    step = path.go_to(1);
    tests += step.tests;
  }
  step.tests = tests;
  const auto take_positions = [&] {
    const std::span<const double> q = path.present().values.position;
    found.q.assign(q.begin(), q.end());
  };
  take_positions();
  found.share = path.present().time;
  found.group = step.group;
  // The last step may have ended with digits to correct.
  if (step.end == PathEnd::same && path.start_at({1, {found.q, {}, {}}})) take_positions();
  return step;
}

/// Leads the drivers from the drawing to their values at a time.
FollowedStep lead_drivers(const Model& m, double time, bool with_turns, bool may_pass,
                          FoundStart& found) {
  Model going = m;
  for (Driver& d : going.drivers) {
    const Entity& e = m.entities[d.coordinate];
    const bool whole = with_turns || e.kind != EntityKind::angle;
    d.motion = straight(m.estimate[e.first], d.motion, time, whole ? INFINITY : turn);
  }
  const FollowedStep step = follow(going, {}, may_pass, found);
  if (step.end == PathEnd::same)
    for (const Driver& d : m.drivers)
      found.q[m.entities[d.coordinate].first] = sample(d.motion, time).position;
  return step;
}

/// Brings angles that are not driven near the drawing. Equations read them as sines and cosines, so
/// whole turns do not matter.
void take_nearest_turns(const Model& m, std::vector<double>& q) {
  const std::vector<bool> driven = independent_coordinates(m);
  for (const Entity& e : m.entities) {
    if (e.fixed || e.kind != EntityKind::angle || driven[e.first]) continue;
    q[e.first] -= turn * std::round((q[e.first] - m.estimate[e.first]) / turn);
  }
}

}  // namespace

FoundStart find_start(const Model& m, double time, bool may_pass) {
  FoundStart found{.q = m.estimate};
  Model at_drawing = m;
  for (Driver& d : at_drawing.drivers)
    d.motion = Polynomial{{m.estimate[m.entities[d.coordinate].first]}};
  // A certificate of the drawing proves all of the homotopy. Its X is symmetric about the drawing,
  // and the homotopy's image is the certificate's with λ times the center, which is inside, too.
  const Certificate drawing = Certifier(at_drawing).certify({0, 0, found.q, {}, {}});
  if (!drawing.proven) {
    found.group = drawing.group;
    if (follow(at_drawing, residual_of_drawing(m), false, found).end != PathEnd::same) {
      found.stage = Stage::drawing;
      return found;
    }
  }
  const FoundStart nominal = found;
  FollowedStep way = lead_drivers(m, time, true, may_pass, found);
  if (way.tests >= BranchPath::max_tests) {
    found = nominal;
    way = lead_drivers(m, time, false, may_pass, found);
  }
  if (way.end != PathEnd::same) found.stage = Stage::drivers;
  take_nearest_turns(m, found.q);
  return found;
}

}  // namespace desmo
