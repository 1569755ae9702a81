#include "formulations/verification/branch/start.h"

#include <array>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "cases/numbers/compensated.h"
#include "formulations/constraints/constraints.h"
#include "formulations/model/scales.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/branch/passage.h"

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
      Kind::residual(x.data(), constants_at<Kind>(c.constants.data(), x.data()).data(), phi.data());
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

/// Returns the angles that are neither driven nor coupled. Equations read them as sines and
/// cosines, so whole turns do not matter.
std::vector<int> free_angles(const Model& m) {
  const std::vector<bool> driven = independent_coordinates(m), coupled = coupled_angles(m);
  std::vector<int> angles;
  for (std::size_t i = 0; i < m.entities.size(); ++i)
    if (const Entity& e = m.entities[i];
        !e.fixed && e.kind == EntityKind::angle && !driven[e.first] && !coupled[i])
      angles.push_back(e.first);
  return angles;
}

/// A way from 0 to 1, in whichever equations of overconstrained groups lead on.
class Way {
 public:
  Way(const Model& m, InitialResidual initial) : model_(&m), initial_(initial) {
    path_ = std::make_unique<BranchPath>(m, BranchPath::max_tests, initial);
  }

  bool start_at(const CertifiedInstant& at) { return begun_ = path_->start_at(at); }

  /// Chooses other equations at a place. Returns whether the way goes on by them.
  bool choose(double share, std::span<const double> q) {
    auto chosen = with_chosen_equations(*model_, q);
    if (!chosen) return false;
    auto path = std::make_unique<BranchPath>(*chosen, BranchPath::max_tests, initial_);
    if (!path->start_at({share, {q, {}, {}}})) return false;
    path_ = std::move(path);
    chosen_ = std::move(chosen);
    model_ = chosen_.get();
    return begun_ = true;
  }

  const Model& model() const { return *model_; }
  BranchPath& path() { return *path_; }
  bool begun() const { return begun_; }

 private:
  const Model* model_;
  const InitialResidual initial_;
  std::unique_ptr<const Model> chosen_;
  std::unique_ptr<BranchPath> path_;
  bool begun_ = false;
};

/// Follows a way from 0 to 1. found: begins at its positions, which are overwritten by the last
/// proven ones. What is regular by other equations of an overconstrained group is no change point,
/// so these are tried first.
FollowedStep follow(const Model& m, InitialResidual initial, bool may_pass, FoundStart& found) {
  Way way(m, initial);
  FollowedStep step;
  int tests = 0;
  double chosen_at = -1;  // share at which other equations were asked for
  const auto take_positions = [&] {
    const std::span<const double> q = way.path().present().values.position;
    found.q.assign(q.begin(), q.end());
  };
  found.share = 0;
  way.start_at({0, {found.q, {}, {}}});
  while (true) {
    if (way.begun()) {
      step = way.path().go_to(1);
      tests += step.tests;
      take_positions();
      found.share = way.path().present().time;
      if (step.end == PathEnd::same) break;
    }
    if (tests >= BranchPath::max_tests) break;
    const bool is_asked = std::exchange(chosen_at, found.share) == found.share;
    if (!is_asked && way.choose(found.share, found.q)) continue;
    if (!way.begun() || !may_pass) break;
    const std::optional<PassedPoint> point = pass_change_point(way.model(), way.path().present());
    if (!point || !(point->before < 1) || !way.start_at(point->beyond())) break;
    found.passed.push_back(point->time);
  }
  step.tests = tests;
  if (way.begun()) found.group = step.group;
  // The last step may have ended with digits to correct.
  if (step.end == PathEnd::same && way.path().start_at({1, {found.q, {}, {}}})) take_positions();
  return step;
}

/// Passes the change point on which the motion begins, if the way of the drivers ends at one.
/// going: the model with the drivers on that way, of which found.share is proven
void pass_at_start(const Model& m, const Model& going, double time, FoundStart& found) {
  std::vector<double> direction;
  for (const Driver& d : going.drivers) direction.push_back(sample(d.motion, found.share).velocity);
  auto point = pass_change_point(m, {0, {found.q, {}, {}}, {}}, direction, time);
  if (!point) return;
  for (const int i : free_angles(m)) {
    const double turns = turn * std::round((found.q[i] - m.estimate[i]) / turn);
    point->polynomials[i].front() -= turns;
    if (!point->values.position.empty()) point->values.position[i] -= turns;
  }
  found.point = std::make_shared<const PassedPoint>(std::move(*point));
}

/// Leads the drivers from the drawing to their values at a time.
FollowedStep lead_drivers(const Model& m, double time, bool with_turns, FoundStart& found) {
  Model going = m;
  for (Driver& d : going.drivers) {
    const Entity& e = m.entities[d.coordinate];
    const bool whole = with_turns || e.kind != EntityKind::angle;
    d.motion = straight(m.estimate[e.first], d.motion, time, whole ? INFINITY : turn);
  }
  const FollowedStep step = follow(going, {}, true, found);
  const bool is_blocked = step.end == PathEnd::stuck && step.tests < BranchPath::max_tests;
  if (is_blocked) pass_at_start(m, going, time, found);
  if (step.end == PathEnd::same)
    for (const Driver& d : m.drivers)
      found.q[m.entities[d.coordinate].first] = sample(d.motion, time).position;
  return step;
}

/// Brings free angles near others.
void take_nearest_turns(const Model& m, std::span<const double> others, std::span<double> q) {
  for (const int i : free_angles(m)) q[i] -= turn * std::round((q[i] - others[i]) / turn);
}

/// A turn leads back where no coordinate is farther from its first place than this, over its
/// natural magnitude: what a slow shaft turns in a turn of a fast one is more, what is rounded is
/// less.
constexpr double max_drift = 1e-9;

/// Returns whether two positions are the same, but for whole turns of angles and for drivers.
bool is_back(const Model& m, std::span<const double> from, std::span<const double> to) {
  const std::vector<bool> driven = independent_coordinates(m);
  const std::vector<double> magnitude = natural_magnitudes(m);
  for (const Entity& e : m.entities)
    for (int i = e.first; !e.fixed && !driven[e.first] && i < e.first + e.size; ++i) {
      const double moved = to[i] - from[i];
      const double drift = e.kind == EntityKind::angle ? std::remainder(moved, turn) : moved;
      if (!(std::abs(drift) <= max_drift * magnitude[i])) return false;
    }
  return true;
}

/// Returns whether a turn of the drivers that are more than one from their values at a time leads
/// back to where it begins. Then further turns do so, too.
bool turn_leads_back(const Model& m, double time, const FoundStart& nominal) {
  Model going = m;
  std::vector<double> back = nominal.q;
  for (Driver& d : going.drivers) {
    const Entity& e = m.entities[d.coordinate];
    const double from = m.estimate[e.first], way = sample(d.motion, time).position - from;
    const bool whole = e.kind == EntityKind::angle && std::abs(way) > turn;
    d.motion = Polynomial{{from, whole ? std::copysign(turn, way) : 0}};
    back[e.first] = sample(d.motion, 1.0).position;
  }
  FoundStart found = nominal;
  BranchPath first(going);
  const std::span<const double> from = first.start_at({0, {nominal.q, {}, {}}})
                                           ? first.present().values.position
                                           : std::span<const double>(nominal.q);
  if (follow(going, {}, true, found).end != PathEnd::same || !is_back(m, from, found.q))
    return false;
  take_nearest_turns(m, found.q, back);
  BranchPath path(going);
  return path.start_at({1, {found.q, {}, {}}}) &&
         path.follow({1, {back, {}, {}}}).end == PathEnd::same;
}

}  // namespace

FoundStart find_start(const Model& m, double time) {
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
  FollowedStep way = lead_drivers(m, time, true, found);
  if (way.tests >= BranchPath::max_tests && turn_leads_back(m, time, nominal)) {
    found = nominal;
    way = lead_drivers(m, time, false, found);
  }
  if (way.end != PathEnd::same) found.stage = Stage::drivers;
  take_nearest_turns(m, m.estimate, found.q);
  return found;
}

}  // namespace desmo
