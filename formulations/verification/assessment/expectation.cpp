#include "formulations/verification/assessment/expectation.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/limits.h"

namespace desmo {

namespace {

/// What neither signal shows, and as much again where bounds have been low.
constexpr double min_margin = 10, doubled = 2;
/// What growth may miss of the direction that a residual happens to have.
constexpr double residual_margin = 2;
/// Growth after which an instant is assessed in any case.
constexpr double risen = 4;

}  // namespace

void Expectation::learn(const Assessment& a, const Signals& signals) {
  if (a.singular || !(a.condition < INFINITY)) return;
  const bool would_be_stated = last_.bound.position > 0 && signals.growth <= risen;
  if (would_be_stated) {
    const Assessment expected = without_margin(signals);
    for (const Level l : all_levels)
      if (expected.bound[l] > 0)
        margin_[l] = std::max(margin_[l], doubled * a.bound[l] / expected.bound[l]);
  }
  last_ = a;
}

void Expectation::rescale(const Scales& from, const Scales& to) {
  desmo::rescale(last_.bound, from, to);
}

Assessment Expectation::without_margin(const Signals& signals) const {
  const auto& [growth, rates, drivers, residual] = signals;
  Assessment a = last_;
  a.condition *= growth;
  a.rounding *= growth;
  a.per_residual *= growth;
  a.bound.position = a.rounding + a.per_residual * residual;
  const double share =
      last_.bound.position > 0 ? std::max(1.0, a.bound.position / last_.bound.position) : growth;
  const double both = growth * rates;
  a.bound.velocity *= share * both * drivers.velocity;
  a.bound.acceleration *= share * both * both * drivers.acceleration;
  return a;
}

Assessment Expectation::operator()(const Signals& signals) const {
  Assessment a = without_margin(signals);
  a.bound.position += (std::max(min_margin, margin_.position) - 1) * a.rounding +
                      (residual_margin - 1) * a.per_residual * signals.residual;
  for (const Level l : {Level::velocity, Level::acceleration})
    a.bound[l] *= std::max(min_margin, margin_[l]);
  return a;
}

}  // namespace desmo
