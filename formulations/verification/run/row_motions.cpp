#include "formulations/verification/run/row_motions.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <variant>

namespace desmo {

RowMotions::RowMotions(const Model& m, Level level) : model_(m), level_(level) {
  for (Driver& d : model_.drivers) d.motion = Polynomial{std::vector<Derived>(6)};  // quintics
  for (std::vector<double>* values : {&from_.position, &from_.velocity, &from_.acceleration})
    values->resize(m.drivers.size());
}

void RowMotions::begin_at(const LiveRow& row) {
  const PerLevel<std::span<const double>> values{row.z, row.zd, row.zdd};
  for (const Level level : all_levels)
    if (level <= level_) std::ranges::copy(values[level], from_[level].begin());
  time_ = row.time;
  has_begun_ = true;
}

double RowMotions::lead_to(const LiveRow& row) {
  const double begin = has_begun_ ? time_ - row.time : 0;
  for (std::size_t d = 0; d < model_.drivers.size(); ++d) lead_driver(d, row, begin);
  return begin;
}

/// Finds the coefficients of z(t) = Σ cₖ tᵏ. The first are those of Taylor's polynomial about the
/// later row z, ż, z̈, at time 0. How far it misses the earlier row z₀, ż₀, z̈₀, at time h < 0,
/// determines the further coefficients. `off`, `rate_off` and `second_off` are these misses, each
/// divided by a power of h:
///
///   z₀ = z + h ż + h²/2 z̈ + h³ off,  ż₀ = ż + h z̈ + h² rate_off,  z̈₀ = z̈ + h second_off
void RowMotions::lead_driver(std::size_t driver, const LiveRow& row, double h) {
  std::vector<Derived>& c = std::get<Polynomial>(model_.drivers[driver].motion).coefficients;
  std::ranges::fill(c, Derived());
  const double z = row.z[driver], v = level_ >= Level::velocity ? row.zd[driver] : 0,
               a = level_ >= Level::acceleration ? row.zdd[driver] : 0;
  c[0] = z, c[1] = v, c[2] = a / 2;
  if (!has_begun_) return;
  const double z0 = from_.position[driver];
  int degree = 1;
  if (level_ == Level::position) {
    c[1] = (z0 - z) / h;
  } else {
    const double off = (z0 - z - h * (v + h * a / 2)) / (h * h * h),
                 rate_off = (from_.velocity[driver] - v - h * a) / (h * h);
    if (level_ == Level::velocity) {
      degree = 3;
      c[2] = h * (3 * off - rate_off), c[3] = rate_off - 2 * off;
    } else {
      degree = 5;
      const double second_off = (from_.acceleration[driver] - a) / h;
      c[3] = 10 * off - 4 * rate_off + second_off / 2;
      c[4] = (-15 * off + 7 * rate_off - second_off) / h;
      c[5] = (6 * off - 3 * rate_off + second_off / 2) / (h * h);
    }
  }
  Derived missed = -Derived(z0);
  for (int k = degree; k >= 0; --k) {
    Derived term = c[k];
    for (int i = 0; i < k; ++i) term = term * Derived(h);
    missed = missed + term;
  }
  constexpr double above = 1 + 0x1p-40;  // covers the rounding of radii, and of the quotient
  c[degree].radius = (std::abs(missed.value) + std::abs(missed.correction) + missed.radius) *
                     above / std::abs(std::pow(h, degree));
}

}  // namespace desmo
