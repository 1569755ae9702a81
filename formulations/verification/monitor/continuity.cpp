#include "formulations/verification/monitor/continuity.h"

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <limits>
#include <numbers>
#include <utility>

#include "formulations/prediction/driver_source.h"
#include "formulations/verification/monitor/running_scales.h"

namespace desmo {

namespace {

/// Of what a group moves in a step, by which the trapezoid rule may be off.
constexpr double smooth = 0.02;
/// By how much an angle may turn more or less than its rates say [rad].
constexpr double turned = 1;
/// By how much it may where it is to be certain that it is not half a turn off [rad].
constexpr double closely_turned = 0.25;
/// Of a step: what does not look continuous over so little is not.
constexpr double shortest = 0x1p-40;
/// What rounding leaves of a difference of times, relative to them: no step is so short.
constexpr double rounding_of_times = 4 * std::numeric_limits<double>::epsilon();
/// Last correction, in magnitudes, of a position that counts as solved.
constexpr double settled = 1e-7;
/// Drivers slower than this, relative to their fastest, tell nothing of what follows them.
constexpr double at_rest = 1e-6;

/// Returns whether the position corrected last counts as solved: its last correction is small, or
/// is what rounding far from the origin leaves of small bodies.
bool has_settled(Assessor& assessor, const Instant& instant) {
  constexpr double unit = 0x1p-52, times = 4, max_settled = 1e-4;
  const double off = assessor.last_correction();
  if (off <= settled) return true;
  if (!(off <= max_settled)) return false;
  double rounding = 0;
  for (const int i : assessor.system().unknowns())
    rounding = std::max(rounding, unit * std::abs(instant.q[i]) / assessor.system().magnitude(i));
  return off <= times * rounding;
}

/// The coordinate that is off most.
constexpr auto worst = [](const auto& off) {
  Eigen::Index coordinate = 0;
  off.maxCoeff(&coordinate);
  return static_cast<int>(coordinate);
};

Eigen::Map<const Eigen::ArrayXd> array(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// Whether angles turn as their rates say, in each place of a register.
template <class Register>
struct AngleTurns {
  typename Register::mask_type follow{true};

  void take(const Instant& to, const State& from, double half_step, const int* angles) {
    const auto of = [angles](std::span<const double> values) {
      return Register([&](int lane) { return values[angles[lane]]; });
    };
    const Register turn = of(to.q) - of(from.q), rates = half_step * (of(from.qd) + of(to.qd));
    follow = follow && abs(turn - rates) <= closely_turned && abs(turn) <= std::numbers::pi;
  }
};

}  // namespace

Continuity::Continuity(const Model& m, const TimeGrid& grid, std::span<const double> magnitude,
                       int max_steps)
    : model_(m),
      turns_(m, grid, magnitude),
      recent_(m.coordinates()),
      turned_(m.coordinates()),
      max_steps_(max_steps) {
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    driven_.push_back({i, 1 / magnitude[i]});
    for (const double t : looks_ahead(grid))
      if (const double v = std::abs(sample(d.motion, t).velocity / magnitude[i]); std::isfinite(v))
        fastest_ = std::max(fastest_, v);
  }
  for (const EntityId e : entity_of_coordinate(m)) group_.push_back(m.entities[e].group);
  const std::vector<bool> driven = independent_coordinates(m);
  for (const Entity& e : m.entities)
    if (!e.fixed && e.kind == EntityKind::angle && !driven[e.first]) angles_.push_back(e.first);
  std::vector<Node*> nodes{&reached_, &next_, &start_, &end_};
  for (Node& node : passage_) nodes.push_back(&node);
  for (Node* node : nodes)
    for (std::vector<double>* values : {&node->state.q, &node->state.qd, &node->state.qdd})
      values->resize(m.coordinates());
}

void Continuity::take(const Instant& instant, bool is_assessed, const PerLevel<double>& stated) {
  recent_.take(instant, is_assessed, stated);
  turns_.forget();
  if (instant.qd.empty()) return;
  fastest_at_last_ = fastest_driver(instant);
  fastest_ = std::max(fastest_, fastest_at_last_);
}

double Continuity::fastest_driver(const Instant& instant) const {
  double fastest = 0;
  for (const auto& [i, unit] : driven_) fastest = std::max(fastest, std::abs(instant.qd[i]) * unit);
  return fastest;
}

void Continuity::expect(const Instant& instant) {
  if (is_known()) turns_.find(recent_[0], instant, 0);
}

/// Returns 1 over what groups move by the measure of a mismatch. fastest: of the drivers at the
/// ends of the step.
double Continuity::per_movement(const Instant& to, double step, double fastest) const {
  const double rate = std::max(fastest, at_rest * fastest_);
  const double movement = to.qdd.empty() ? std::abs(step) * rate : rate;
  return movement > 0 ? 1 / movement : 0;
}

/// found(what the trapezoid rule is off by, relative to what groups move).
template <class Found>
auto Continuity::mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights,
                          Found&& found) const {
  const double h = to.time - from.time;
  const double unit = per_movement(to, h, std::max(fastest_driver(from), fastest_driver(to)));
  const auto off = [&](std::span<const double> x0, std::span<const double> x1,
                       std::span<const double> rate0, std::span<const double> rate1) {
    return found((array(x1) - array(x0) - h / 2 * (array(rate0) + array(rate1))).abs() * weights *
                 unit);
  };
  return to.qdd.empty() ? off(from.q, to.q, from.qd, to.qd) : off(from.qd, to.qd, from.qdd, to.qdd);
}

double Continuity::mismatch(const Instant& from, const Instant& to,
                            const Eigen::ArrayXd& weights) const {
  if (to.qd.empty() || weights.size() == 0) return 0;  // positions alone do not tell
  return mismatch(from, to, weights, [](const auto& off) { return off.maxCoeff(); });
}

/// The same of positions, relative to what groups move when the drivers move by their magnitudes:
/// whole turns of an angle do not show in its rates.
const Eigen::ArrayXd& Continuity::position_mismatch(const Instant& from, const Instant& to,
                                                    const Eigen::ArrayXd& weights) {
  const double h = to.time - from.time;
  return turned_ = (array(to.q) - array(from.q) - h / 2 * (array(from.qd) + array(to.qd))).abs() *
                   weights;
}

/// How many times as fast as usual a group moves, at least 1: near a dead point.
double Continuity::growth(const Instant& instant, const Eigen::ArrayXd& weights) const {
  const double drivers = std::max(fastest_driver(instant), at_rest * fastest_);
  return std::max(1.0, (array(instant.qd).abs() * weights).maxCoeff() / drivers);
}

/// What movement the rates at both ends are to agree to.
double Continuity::moved(const Instant& from, const Instant& to,
                         const Eigen::ArrayXd& weights) const {
  return std::max(growth(from, weights), growth(to, weights));
}

/// Whether positions and rates of one instant lead to the other; sets turned_.
bool Continuity::leads_on(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights) {
  const double allowed = smooth * moved(from, to, weights);
  const Eigen::ArrayXd& turned = position_mismatch(from, to, weights);
  return mismatch(from, to, weights) <= allowed && turned.maxCoeff() <= allowed &&
         !turns_further(from, to, weights);
}

bool Continuity::in_doubt(const Instant& instant, const Eigen::ArrayXd& weights,
                          double min_excursion, const std::optional<StepMeasures>& measures,
                          bool with_turns) {
  const double least = std::min(min_excursion, std::exchange(min_excursion_, min_excursion));
  angles_follow_ = is_known() && do_angles_follow(instant);
  if (!is_known() || weights.size() == 0) return false;
  if (with_turns && turns_.find(recent_[0], instant, least)) return true;
  const Instant last = view_of(recent_[0], instant);
  const auto measured = [&] {
    const double fastest = std::max(fastest_at_last_, fastest_driver(instant));
    return measures->mismatch * per_movement(instant, instant.time - last.time, fastest);
  };
  double off = measures ? measured() : mismatch(last, instant, weights);
  if (measures && measures->is_bound && !(off <= smooth)) off = mismatch(last, instant, weights);
  return off > smooth || (!angles_follow_ && turns_further(last, instant, weights));
}

/// Returns whether every unknown angle turns as its rates say, to `closely_turned`, and by half a
/// turn at most.
bool Continuity::do_angles_follow(const Instant& instant) const {
  if (instant.qd.empty()) return false;
  const State& last = recent_[0].state;
  const double half = (instant.time - recent_[0].time) / 2;
  AngleTurns<std::experimental::native_simd<double>> many;
  AngleTurns<std::experimental::simd<double, std::experimental::simd_abi::scalar>> one;
  const int n = static_cast<int>(angles_.size()), width = static_cast<int>(many.follow.size());
  int k = 0;
  for (; k + width <= n; k += width) many.take(instant, last, half, angles_.data() + k);
  for (; k < n; ++k) one.take(instant, last, half, angles_.data() + k);
  return all_of(many.follow) && all_of(one.follow);
}

/// Whether an angle turns by more than its rates say, as by a whole turn.
bool Continuity::turns_further(const Instant& from, const Instant& to,
                               const Eigen::ArrayXd& weights) const {
  if (to.qd.empty() || weights.size() == 0) return false;
  const double h = to.time - from.time;
  return std::ranges::any_of(angles_, [&](int i) {
    return weights[i] > 0 &&
           !(std::abs(to.q[i] - from.q[i] - h / 2 * (from.qd[i] + to.qd[i])) <= turned);
  });
}

/// next_ = the solution at t that Taylor's polynomial from reached_ leads to.
void Continuity::predict(double t, const Instant& like, Assessor& assessor) {
  const double h = t - reached_.time;
  const State& from = reached_.state;
  for (int i = 0; i < model_.coordinates(); ++i) {
    const double a = like.qdd.empty() ? 0 : from.qdd[i];
    next_.state.q[i] = from.q[i] + h * (from.qd[i] + h / 2 * a);
    next_.state.qd[i] = from.qd[i] + h * a;
    next_.state.qdd[i] = from.qdd[i];
  }
  next_.time = t;
  write_drivers(model_, t, next_.state);
  const Instant solved = assessor.corrected(view_of(next_, like));
  std::ranges::copy(solved.q, next_.state.q.begin());
  std::ranges::copy(solved.qd, next_.state.qd.begin());
  std::ranges::copy(solved.qdd, next_.state.qdd.begin());
}

std::optional<Continuity::Jump> Continuity::find_jump(const Instant& instant, const Means& means) {
  return go(instant, End::given, means);
}

std::optional<Instant> Continuity::solve_anew(const Instant& instant, const Means& means,
                                              Level known) {
  if (!is_known() || instant.qd.empty() || means.weights.size() == 0) return {};
  Instant like = instant;
  if (known < Level::acceleration) like.qdd = {};
  if (go(like, End::solved, means)) return {};
  return view_of(next_, instant);
}

/// Goes from the instant taken last. What a coarse tolerance leaves off at the ends does not lead
/// on as movement does: where there is a jump, it goes again between ends that are corrected.
std::optional<Continuity::Jump> Continuity::go(const Instant& instant, End end,
                                               const Means& means) {
  const auto jump = go(recent_[0], instant, end, means);
  if (!jump) return jump;
  correct(view_of(recent_[0], instant), means.assessor, start_);
  if (end == End::solved) return go(start_, instant, end, means);
  correct(instant, means.assessor, end_);
  return go(start_, view_of(end_, instant), end, means);
}

/// result = the instant corrected by Newton's method, if that settles.
void Continuity::correct(const Instant& instant, Assessor& assessor, Node& result) {
  Instant solved = assessor.corrected(driven(instant));
  if (!has_settled(assessor, solved)) solved = instant;
  result.time = instant.time;
  std::ranges::copy(solved.q, result.state.q.begin());
  std::ranges::copy(solved.qd, result.state.qd.begin());
  std::ranges::copy(solved.qdd, result.state.qdd.begin());
}

std::optional<Continuity::Jump> Continuity::go(const Node& start, const Instant& instant, End end,
                                               const Means& means) {
  const auto& [assessor, scales, weights, signs] = means;
  passed_.reset();
  const double whole = instant.time - start.time;
  const double latest = std::max(std::abs(start.time), std::abs(instant.time));
  const double least = std::max(shortest * std::abs(whole), rounding_of_times * latest);
  std::span<const double> turns = turns_.times();  // that are ahead
  reached_ = start;
  double step = whole / 2;
  bool to_turn = false;
  const auto jump = [&](const Instant& from, const Instant& to, int coordinate) {
    return Jump{{from.time, to.time, group_[coordinate], SingularityCrossing::Kind::jumped},
                to_turn};
  };
  for (int i = 0; i < max_steps_; ++i) {
    while (!turns.empty() && turns[0] - reached_.time <= least) turns = turns.subspan(1);
    to_turn = !turns.empty() && turns[0] < instant.time - least;
    const double target = to_turn ? turns[0] : instant.time, left = target - reached_.time;
    // What rounding leaves of the way is no step: rates cannot be told by it.
    const bool to_end = std::abs(step) + least >= std::abs(left);
    const bool is_given = to_end && !to_turn && end == End::given;
    if (!is_given) predict(to_end ? target : reached_.time + step, instant, assessor);
    const Instant next = is_given ? instant : view_of(next_, instant);
    const Instant from = view_of(reached_, instant);
    const bool is_solved = is_given || has_settled(assessor, next);
    if (is_solved && leads_on(from, next, weights)) {
      if (to_end && !to_turn) return {};
      if (to_end) {
        if (const Assessment a = assessor(next, scales); a.singular)
          return Jump{{from.time, target, a.group, SingularityCrossing::Kind::jumped}, true};
        if (const int block = signs.changed_block(); block >= 0) {
          passed_ = {start.time, target, assessor.system().group_of_block(block),
                     SingularityCrossing::Kind::passed};
          if (end == End::given) return Jump{*passed_, true};
        }
        turns = turns.subspan(1);
      }
      std::swap(reached_, next_);
      step *= 2;
    } else if (std::abs(step) > least) {
      step = (to_end ? left : step) / 2;
    } else {
      const bool rates_agree = mismatch(from, next, weights) <= smooth * moved(from, next, weights);
      return jump(from, next, rates_agree ? worst(turned_) : mismatch(from, next, weights, worst));
    }
  }
  const Instant from = view_of(reached_, instant);
  return jump(from, instant, mismatch(from, instant, weights, worst));
}

}  // namespace desmo
