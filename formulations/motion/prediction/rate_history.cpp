#include "formulations/motion/prediction/rate_history.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "formulations/base/lane_values.h"
#include "formulations/motion/prediction/guess.h"

namespace desmo {

namespace {

/// Limit of the relative difference of two intervals that count as equal (<): the times of a grid
/// are rounded.
constexpr double interval_tolerance = 1e-11;

/// Sizes of the blocks of coordinates that are predicted together. Numbers in lanes come in blocks
/// of 8 or 4; other ranges are often single coordinates.
constexpr std::array block_sizes{8, 4, 1};

/// Gauss's points and weights on [0, 1], exact up to degree 7: that of a polynomial through values
/// and derivatives at four instants.
constexpr int points = RateHistory::instants;
constexpr std::array<double, points> point{0.069431844202973712388, 0.33000947820757186760,
                                           0.66999052179242813240, 0.93056815579702628761};
constexpr std::array<double, points> weight{0.17392742256872692869, 0.32607257743127307131,
                                            0.32607257743127307131, 0.17392742256872692869};

/// Returns whether the intervals are `ratios` times h, except for rounding.
template <std::size_t size>
bool are_ratios(const std::array<double, size>& intervals, const std::array<double, size>& ratios,
                double h) {
  bool all = true;
  for (std::size_t j = 0; j < size; ++j)
    all &= std::abs(intervals[j] - ratios[j] * h) < interval_tolerance * std::abs(intervals[j]);
  return all;
}

}  // namespace

RateHistory::RateHistory(std::span<const IndexRange> ranges) {
  const auto cut_by = [&](int block) {
    return std::ranges::all_of(ranges, [=](const IndexRange& range) {
      return range.first % block == 0 && range.end % block == 0;
    });
  };
  block_ = *std::ranges::find_if(block_sizes, cut_by);
  for (const IndexRange range : ranges)
    for (int i = range.first; i < range.end; i += block_) blocks_.push_back(i);
  changes_.resize(blocks_.size() * block_);
  rates_.resize(2 * changes_.size() * instants);
}

/// The change of each coordinate in a step, Σ_j (h β_j q̇_j + h² γ_j q̈_j), with the instants j in
/// the order of rates_.
struct RateHistory::Change {
  Change(const RateHistory& of, double h) : rates(of.rates_.data()), size(of.changes_.size()) {
    for (std::size_t k = 0; k < instants; ++k) {
      b[k] = h * of.beta_[instants - 1 - of.newest_ + k];
      c[k] = h * h * of.gamma_[instants - 1 - of.newest_ + k];
    }
  }

  /// Returns the change of coordinate n. It is computed as two sums, so that neither waits for the
  /// other.
  double operator()(std::size_t n) const {
    double of_qd = 0, of_qdd = 0;
    for (std::size_t k = 0; k < instants; ++k) {
      of_qd += b[k] * rates[2 * k * size + n];
      of_qdd += c[k] * rates[(2 * k + 1) * size + n];
    }
    return of_qd + of_qdd;
  }

  const double* rates;
  std::size_t size;
  std::array<double, instants> b, c;
};

template <std::size_t block>
void RateHistory::remember(const double* qd, const double* qdd) {
  double *v = rates_.data() + 2 * newest_ * changes_.size(), *a = v + changes_.size();
  for (const int i : blocks_) {
    copy_in_registers<block>(qd + i, v);
    copy_in_registers<block>(qdd + i, a);
    v += block, a += block;
  }
}

/// q may be last: a block is written when all of it is known.
template <std::size_t block>
void RateHistory::write_predicted(const Change& change, const double* last, double* q) {
  for (std::size_t m = 0; m < blocks_.size(); ++m) {
    const int i = blocks_[m];
    std::array<double, block> expected;
    for (std::size_t k = 0; k < block; ++k) expected[k] = last[i + k] + change(m * block + k);
    copy_in_registers<block>(expected.data(), q + i);
  }
}

/// All changes are computed first, in a loop that fits wide registers.
template <>
void RateHistory::write_predicted<1>(const Change& change, const double* last, double* q) {
#pragma GCC ivdep  // changes_ does not overlap the rates
  for (std::size_t n = 0; n < changes_.size(); ++n) changes_[n] = change(n);
  for (std::size_t n = 0; n < blocks_.size(); ++n) q[blocks_[n]] = last[blocks_[n]] + changes_[n];
}

bool RateHistory::predict(double interval, double h, const double* last, const double* qd,
                          const double* qdd, double* q) {
  known_ = std::min(known_ + 1, instants);
  newest_ = (newest_ + 1) % instants;  // the last instant takes the place of the oldest
  for (std::size_t j = intervals_.size() - 1; j > 0; --j) intervals_[j] = intervals_[j - 1];
  intervals_[0] = interval;
  const bool predicts =
      known_ == instants && h != 0 && (are_ratios(intervals_, weighed_, h) || weigh(h));
  const auto go = [&](auto block) {
    remember<block()>(qd, qdd);
    if (predicts) write_predicted<block()>(Change(*this, h), last, q);
  };
  if (block_ == 8)
    go(std::integral_constant<std::size_t, 8>());
  else if (block_ == 4)
    go(std::integral_constant<std::size_t, 4>());
  else
    go(std::integral_constant<std::size_t, 1>());
  return predicts;
}

/// Computes the weights for a step of h [s]. They are the integrals over the step of Hermite's
/// basis at the instants x_j, in units of h. With Lagrange's ℓ_j:
///   β_j = ∫ (1 − 2 ℓ_j′(x_j) (x − x_j)) ℓ_j², γ_j = ∫ (x − x_j) ℓ_j².
/// Returns false where intervals have different signs or one is too short (max_step_growth).
bool RateHistory::weigh(double h) {
  Intervals ratios;
  for (std::size_t j = 0; j < ratios.size(); ++j) ratios[j] = intervals_[j] / h;
  const auto forward = [](double ratio) { return ratio * max_step_growth > 1; };
  const auto backward = [](double ratio) { return ratio * max_step_growth < -1; };
  if (!std::ranges::all_of(ratios, forward) && !std::ranges::all_of(ratios, backward)) return false;
  std::array<double, instants> x{};  // the instants in units of h
  for (int j = 1; j < instants; ++j) x[j] = x[j - 1] - ratios[j - 1];
  for (int j = 0; j < instants; ++j) {
    double slope = 0;
    for (int m = 0; m < instants; ++m)
      if (m != j) slope += 1 / (x[j] - x[m]);
    double beta = 0, gamma = 0;
    for (int p = 0; p < points; ++p) {
      double lagrange = 1;
      for (int m = 0; m < instants; ++m)
        if (m != j) lagrange *= (point[p] - x[m]) / (x[j] - x[m]);
      const double from = point[p] - x[j], share = weight[p] * lagrange * lagrange;
      beta += (1 - 2 * slope * from) * share;
      gamma += from * share;
    }
    for (int at = instants - 1 - j; at < 2 * instants - 1; at += instants) {
      beta_[at] = beta;
      gamma_[at] = gamma;
    }
  }
  weighed_ = ratios;
  return true;
}

}  // namespace desmo
