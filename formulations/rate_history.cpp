#include "formulations/rate_history.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "formulations/guess.h"

namespace desmo {

namespace {

/// Intervals that differ by less are the same: the times of a grid are rounded.
constexpr double same = 1e-11;

/// Lanes come in blocks; whatever else is predicted, many runs are of one.
constexpr std::array block_sizes{8, 4, 1};

/// Gauss's points and weights on [0, 1], exact up to degree 7: that of a polynomial through values
/// and derivatives at four instants.
constexpr int points = RateHistory::instants;
constexpr std::array<double, points> point{0.069431844202973712388, 0.33000947820757186760,
                                           0.66999052179242813240, 0.93056815579702628761};
constexpr std::array<double, points> weight{0.17392742256872692869, 0.32607257743127307131,
                                            0.32607257743127307131, 0.17392742256872692869};

/// In registers: so few numbers are not worth a call.
template <std::size_t size>
void copy(const double* __restrict from, double* __restrict to) {
  for (std::size_t k = 0; k < size; ++k) to[k] = from[k];
}

/// The others move up, and the last is gone.
template <class T, std::size_t size>
void put_first(T first, std::array<T, size>& values) {
  for (std::size_t k = size - 1; k > 0; --k) values[k] = values[k - 1];
  values[0] = first;
}

}  // namespace

RateHistory::RateHistory(std::span<const CoordinateRun> runs) {
  const auto cut_by = [&](int block) {
    return std::ranges::all_of(runs, [=](const CoordinateRun& run) {
      return run.first % block == 0 && run.end % block == 0;
    });
  };
  block_ = *std::ranges::find_if(block_sizes, cut_by);
  for (const CoordinateRun run : runs)
    for (int i = run.first; i < run.end; i += block_) blocks_.push_back(i);
  const std::size_t size = blocks_.size() * block_;
  rates_.resize(2 * size * instants);
  change_.resize(size);
  for (int j = 0; j < instants; ++j) at_[j] = 2 * size * j;
}

/// visit(n, i, block): numbers n … n + block − 1 among the coordinates are coordinates i and so on.
template <class Visit>
void RateHistory::for_blocks(Visit&& visit) const {
  const auto of_size = [&](auto block) {
    for (std::size_t b = 0; b < blocks_.size(); ++b) visit(b * block, blocks_[b], block);
  };
  if (block_ == 8)
    of_size(std::integral_constant<std::size_t, 8>());
  else if (block_ == 4)
    of_size(std::integral_constant<std::size_t, 4>());
  else
    of_size(std::integral_constant<std::size_t, 1>());
}

/// Σ_j (h β_j q̇_j + h² γ_j q̈_j) of one of the coordinates.
struct RateHistory::Change {
  std::array<const double*, instants> qd, qdd;  // of the last instant not read
  std::array<double, instants> b, c;

  /// now_qd, now_qdd: of the last instant. Two sums: neither waits for the other.
  double operator()(std::size_t n, double now_qd, double now_qdd) const {
    const double of_qd = b[3] * qd[3][n] + b[2] * qd[2][n] + b[1] * qd[1][n] + b[0] * now_qd;
    const double of_qdd = c[3] * qdd[3][n] + c[2] * qdd[2][n] + c[1] * qdd[1][n] + c[0] * now_qdd;
    return of_qdd + of_qd;
  }
};

RateHistory::Change RateHistory::change_over(double h) const {
  Change change;
  for (int j = 0; j < instants; ++j) {
    change.qd[j] = rates_.data() + at_[j];
    change.qdd[j] = change.qd[j] + change_.size();
    change.b[j] = h * beta_[j];
    change.c[j] = h * h * gamma_[j];
  }
  return change;
}

bool RateHistory::lead_on(double interval, double h, const double* last, const double* qd,
                          const double* qdd, double* q) {
  known_ = std::min(known_ + 1, instants);
  put_first(at_.back(), at_);  // in the place of the oldest
  put_first(interval, intervals_);
  double* const v = rates_.data() + at_[0];
  double* const a = v + change_.size();
  const bool leads = known_ == instants && h != 0 && (weighed_for(h) || weigh(h));
  const Change change = change_over(h);
  if (leads && block_ > 1) {
    for_blocks([=](std::size_t n, int i, auto block) {
      std::array<double, block()> now_v, now_a, expected;  // q may be last
      copy<block()>(qd + i, now_v.data());
      copy<block()>(qdd + i, now_a.data());
      for (std::size_t k = 0; k < block(); ++k)
        expected[k] = last[i + k] + change(n + k, now_v[k], now_a[k]);
      copy<block()>(now_v.data(), v + n);
      copy<block()>(now_a.data(), a + n);
      copy<block()>(expected.data(), q + i);
    });
    return true;
  }
  for_blocks([=](std::size_t n, int i, auto block) {
    copy<block()>(qd + i, v + n);
    copy<block()>(qdd + i, a + n);
  });
  if (!leads) return false;
  double* __restrict const changes = change_.data();
  for (std::size_t n = 0; n < change_.size(); ++n) changes[n] = change(n, v[n], a[n]);
  for (std::size_t n = 0; n < blocks_.size(); ++n) q[blocks_[n]] = last[blocks_[n]] + change_[n];
  return true;
}

bool RateHistory::weighed_for(double h) const {
  bool all = true;
  for (std::size_t j = 0; j < weighed_.size(); ++j)
    all &= std::abs(intervals_[j] - weighed_[j] * h) < same * std::abs(intervals_[j]);
  return all;
}

/// The integrals over the step of Hermite's basis at the instants, with ℓ_j of Lagrange:
///   β_j = ∫ (1 − 2 ℓ_j′(x_j) (x − x_j)) ℓ_j², γ_j = ∫ (x − x_j) ℓ_j².
/// False where intervals do not go one way or one is short.
bool RateHistory::weigh(double h) {
  Ratios ratios;
  for (std::size_t j = 0; j < ratios.size(); ++j) ratios[j] = intervals_[j] / h;
  const auto forward = [](double ratio) { return ratio * longest_stretch > 1; };
  const auto backward = [](double ratio) { return ratio * longest_stretch < -1; };
  if (!std::ranges::all_of(ratios, forward) && !std::ranges::all_of(ratios, backward)) return false;
  std::array<double, instants> x{};  // the instants in units of h
  for (int j = 1; j < instants; ++j) x[j] = x[j - 1] - ratios[j - 1];
  for (int j = 0; j < instants; ++j) {
    double slope = 0;
    for (int m = 0; m < instants; ++m)
      if (m != j) slope += 1 / (x[j] - x[m]);
    beta_[j] = gamma_[j] = 0;
    for (int p = 0; p < points; ++p) {
      double lagrange = 1;
      for (int m = 0; m < instants; ++m)
        if (m != j) lagrange *= (point[p] - x[m]) / (x[j] - x[m]);
      const double from = point[p] - x[j], share = weight[p] * lagrange * lagrange;
      beta_[j] += (1 - 2 * slope * from) * share;
      gamma_[j] += from * share;
    }
  }
  weighed_ = ratios;
  return true;
}

}  // namespace desmo
