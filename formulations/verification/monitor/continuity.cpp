#include "formulations/verification/monitor/continuity.h"

#include <algorithm>
#include <cmath>

#include "formulations/prediction/driver_source.h"
#include "formulations/verification/monitor/running_scales.h"

namespace desmo {

namespace {

/// Of what a group moves in a step, by which the trapezoid rule may be off.
constexpr double smooth = 0.02;
/// Of a step: what does not look continuous over so little is not.
constexpr double shortest = 0x1p-40;
/// Drivers slower than this, relative to their fastest, tell nothing of what follows them.
constexpr double at_rest = 1e-6;

/// The coordinate that is off most.
constexpr auto worst = [](const auto& off) {
  Eigen::Index coordinate = 0;
  off.maxCoeff(&coordinate);
  return static_cast<int>(coordinate);
};

Eigen::Map<const Eigen::ArrayXd> array(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

Continuity::Continuity(const Model& m, const TimeGrid& grid, std::span<const double> magnitude,
                       int max_steps)
    : model_(m), turned_(m.coordinates()), max_steps_(max_steps) {
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    driven_.push_back({i, 1 / magnitude[i]});
    for (const double t : looks_ahead(grid))
      if (const double v = std::abs(sample(d.motion, t).velocity / magnitude[i]); std::isfinite(v))
        fastest_ = std::max(fastest_, v);
  }
  for (Node* node : {&last_, &reached_, &next_})
    for (std::vector<double>* values : {&node->state.q, &node->state.qd, &node->state.qdd})
      values->resize(m.coordinates());
}

void Continuity::Node::take(const Instant& instant) {
  const auto copy = [](std::span<const double> from, std::vector<double>& to) {
    std::copy_n(from.data(), from.size(), to.data());
  };
  time = instant.time;
  copy(instant.q, state.q);
  copy(instant.qd, state.qd);
  copy(instant.qdd, state.qdd);
}

void Continuity::take(const Instant& instant) {
  last_.take(instant);
  known_ = true;
  if (!instant.qd.empty()) fastest_ = std::max(fastest_, fastest_driver(instant));
}

double Continuity::fastest_driver(const Instant& instant) const {
  double fastest = 0;
  for (const auto& [i, unit] : driven_) fastest = std::max(fastest, std::abs(instant.qd[i]) * unit);
  return fastest;
}

/// A node, as far as an instant is solved.
Instant Continuity::view(const Node& node, const Instant& like) const {
  Instant result = like;
  result.time = node.time;
  result.q = node.state.q;
  if (!like.qd.empty()) result.qd = node.state.qd;
  if (!like.qdd.empty()) result.qdd = node.state.qdd;
  return result;
}

/// found(what the trapezoid rule is off by, relative to what groups move).
template <class Found>
auto Continuity::mismatch(const Instant& from, const Instant& to, const Eigen::ArrayXd& weights,
                          Found&& found) const {
  const double h = to.time - from.time;
  const double fastest = std::max({fastest_driver(from), fastest_driver(to), at_rest * fastest_});
  const auto off = [&](std::span<const double> x0, std::span<const double> x1,
                       std::span<const double> rate0, std::span<const double> rate1, double unit) {
    return found((array(x1) - array(x0) - h / 2 * (array(rate0) + array(rate1))).abs() * weights *
                 (unit > 0 ? 1 / unit : 0));
  };
  return to.qdd.empty() ? off(from.q, to.q, from.qd, to.qd, std::abs(h) * fastest)
                        : off(from.qd, to.qd, from.qdd, to.qdd, fastest);
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

bool Continuity::in_doubt(const Instant& instant, const Eigen::ArrayXd& weights) const {
  return known_ && mismatch(view(last_, instant), instant, weights) > smooth;
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
  const Instant solved = assessor.corrected(view(next_, like));
  std::ranges::copy(solved.q, next_.state.q.begin());
  std::ranges::copy(solved.qd, next_.state.qd.begin());
  std::ranges::copy(solved.qdd, next_.state.qdd.begin());
}

std::optional<Continuity::Jump> Continuity::find_jump(const Instant& instant,
                                                      const Eigen::ArrayXd& weights,
                                                      Assessor& assessor) {
  return go(instant, End::given, weights, assessor);
}

std::optional<Instant> Continuity::solve_anew(const Instant& instant, const Eigen::ArrayXd& weights,
                                              Assessor& assessor) {
  if (!known_ || instant.qd.empty() || weights.size() == 0) return {};
  if (go(instant, End::solved, weights, assessor)) return {};
  return view(next_, instant);
}

Instant Continuity::driven(const Instant& instant) {
  next_.take(instant);
  write_drivers(model_, instant.time, next_.state);
  return view(next_, instant);
}

std::optional<Continuity::Jump> Continuity::go(const Instant& instant, End end,
                                               const Eigen::ArrayXd& weights, Assessor& assessor) {
  const double whole = instant.time - last_.time;
  reached_ = last_;
  double step = whole / 2;
  for (int i = 0; i < max_steps_; ++i) {
    const bool to_end = std::abs(step) >= std::abs(instant.time - reached_.time);
    const bool is_given = to_end && end == End::given;
    if (!is_given) predict(to_end ? instant.time : reached_.time + step, instant, assessor);
    const Instant next = is_given ? instant : view(next_, instant);
    const Instant from = view(reached_, instant);
    const double moved = std::max(growth(from, weights), growth(next, weights));
    const bool rates_agree = mismatch(from, next, weights) <= smooth * moved;
    const Eigen::ArrayXd& turned = position_mismatch(from, next, weights);
    if (rates_agree && turned.maxCoeff() <= smooth * moved) {
      if (to_end) return {};
      std::swap(reached_, next_);
      step *= 2;
    } else if (std::abs(step) > shortest * std::abs(whole)) {
      step = (to_end ? instant.time - reached_.time : step) / 2;
    } else {
      return Jump{from.time, next.time,
                  rates_agree ? worst(turned) : mismatch(from, next, weights, worst)};
    }
  }
  return Jump{reached_.time, instant.time,
              mismatch(view(reached_, instant), instant, weights, worst)};
}

}  // namespace desmo
