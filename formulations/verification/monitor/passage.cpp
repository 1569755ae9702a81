// Passing a singular position at which the motion is smooth.
#include <array>

#include "formulations/prediction/driver_source.h"
#include "formulations/verification/monitor/continuity.h"

namespace desmo {

/// result = the polynomial through what is solved at two nodes, at result.time.
void Continuity::interpolate(const Node& from, const Node& to, const Instant& like,
                             Node& result) const {
  const double h = to.time - from.time, x = (result.time - from.time) / h;
  for (int i = 0; i < model_.coordinates(); ++i) {
    // p(x) = q₀ + x (v₀ + x (a₀/2 + x (c₃ + x (c₄ + x c₅)))), x from 0 to 1
    const auto& [q0, v0, a0] = from.state;
    const auto& [q1, v1, a1] = to.state;
    const double v = h * v0[i], w = h * v1[i];
    std::array<double, 6> c{q0[i], v};
    if (like.qdd.empty()) {
      const double rest = q1[i] - q0[i] - v;
      c[2] = 3 * rest - (w - v), c[3] = (w - v) - 2 * rest;
    } else {
      const double a = h * h * a0[i], b = h * h * a1[i];
      const double rest = q1[i] - q0[i] - v - a / 2, rate = w - v - a, second = b - a;
      c[2] = a / 2, c[3] = 10 * rest - 4 * rate + second / 2;
      c[4] = -15 * rest + 7 * rate - second, c[5] = 6 * rest - 3 * rate + second / 2;
    }
    double p = 0, dp = 0, ddp = 0;
    for (int k = 5; k >= 0; --k) {
      ddp = ddp * x + 2 * dp;
      dp = dp * x + p;
      p = p * x + c[k];
    }
    result.state.q[i] = p;
    result.state.qd[i] = dp / h;
    result.state.qdd[i] = ddp / (h * h);
  }
  write_drivers(model_, result.time, result.state);
}

std::optional<Continuity::Passage> Continuity::pass(const Instant& singular, const Means& means) {
  const auto& [assessor, scales, weights, signs] = means;
  if (!is_known() || singular.qd.empty() || weights.size() == 0) return {};
  constexpr int max_tries = 8;
  auto& [before2, before, beyond, beyond2, between, wide] = passage_;
  const double whole = singular.time - recent_[0].time;
  double distance = whole / 2;
  for (int i = 0; i < max_tries; ++i, distance /= 2) {
    const auto reach = [&](double from_singular, Node& node) {
      Instant target = singular;
      target.time = singular.time - from_singular;
      if (from_singular >= whole) {
        node = recent_[0];
        return true;
      }
      if (go(target, End::solved, means) || passed_) return false;
      node = next_;
      return true;
    };
    const auto lead = [&](const Node& from, double to, Node& node) {
      reached_ = from;
      predict(to, singular, assessor);
      node = next_;
      return leads_on(view_of(from, singular), view_of(node, singular), weights);
    };
    if (!reach(2 * distance, before2) || !reach(distance, before)) return {};
    if (!lead(before, singular.time + distance, beyond) ||
        !lead(beyond, singular.time + 2 * distance, beyond2))
      continue;
    const Assessment assessment = assessor(view_of(beyond, singular), scales);
    if (assessment.singular) continue;
    between.time = wide.time = singular.time;
    interpolate(before, beyond, singular, between);
    interpolate(before2, beyond2, singular, wide);
    return Passage{view_of(between, singular),
                   view_of(wide, singular),
                   before.time,
                   beyond.time,
                   beyond.state.q,
                   assessment};
  }
  return {};
}

Instant Continuity::driven(const Instant& instant) {
  next_.time = instant.time;
  std::ranges::copy(instant.q, next_.state.q.begin());
  std::ranges::copy(instant.qd, next_.state.qd.begin());
  std::ranges::copy(instant.qdd, next_.state.qdd.begin());
  write_drivers(model_, instant.time, next_.state);
  return view_of(next_, instant);
}

}  // namespace desmo
