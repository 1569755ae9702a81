#include "formulations/verification/assessment/expectation.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/assessment/limits.h"

namespace desmo {

namespace {

/// By how much a residual may rise above those assessed, and a condition number likewise.
constexpr double risen = 4;
/// Residuals below it are rounding.
constexpr double min_residual = 1e-15;
/// Of expectations: what neither signal shows, and as much again where they have been off.
constexpr double min_margin = 10, doubled = 2;

}  // namespace

void Expectation::learn(const Assessment& a, double growth, double residual) {
  if (a.singular || !(a.condition < INFINITY)) return;
  const bool would_be_stated = last_.bound.position > 0 && growth <= risen && !is_new(residual);
  if (would_be_stated) {
    const Assessment expected = (*this)(growth, residual);
    for (const Level l : levels)
      if (expected.bound[l] > 0)
        margin_[l] = std::max(margin_[l], doubled * a.bound[l] / expected.bound[l]);
  }
  max_residual_ = std::max(max_residual_, residual);
  if (residual > min_residual)
    slope_ = std::max(0.0, a.bound.position - a.rounding) / (a.condition * residual);
  last_ = a;
}

void Expectation::rescale(const Scales& from, const Scales& to) {
  desmo::rescale(last_.bound, from, to);
}

Assessment Expectation::operator()(double growth, double residual) const {
  Assessment a = last_;
  a.condition *= growth;
  a.rounding *= growth;
  a.bound.position = a.rounding + a.condition * slope_ * residual;
  const double share = last_.bound.position > 0 ? a.bound.position / last_.bound.position : growth;
  const double square = growth * growth;
  a.bound.velocity *= share * square;
  a.bound.acceleration *= share * square * square;
  return a;
}

Assessment Expectation::with_margin(Assessment expected) const {
  for (const Level l : levels) expected.bound[l] *= std::max(min_margin, margin_[l]);
  return expected;
}

bool Expectation::is_new(double residual) const {
  return residual > min_residual && residual > risen * max_residual_;
}

}  // namespace desmo
