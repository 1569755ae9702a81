#include "formulations/verification/certificate/preconditioner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

namespace {

/// Returns the smallest number in the given lanes.
double smallest(const LaneNumbers& x, LaneMask lanes) {
  const LaneNumbers y = select(lanes, x, INFINITY);
  return std::min(std::min(y[0], y[1]), std::min(y[2], y[3]));
}

/// Makes step k of an inversion by Gauss–Jordan elimination, in place.
template <int N>
void eliminate(LaneNumbers* a, int size, int k) {
  const int n = N > 0 ? N : size;
  LaneNumbers* const from = a + k * n;
  const LaneNumbers scale = LaneNumbers(1) / from[k];
  from[k] = 1;
  for (int j = 0; j < n; ++j) from[j] *= scale;
  LaneNumbers* to = a;
  for (int i = 0; i < n; ++i, to += n) {
    if (i == k) continue;
    const LaneNumbers factor = -to[k];
    if (N == 0 && !(!is_zero(factor)).any()) continue;
    to[k] = 0;
#pragma GCC unroll 4
    for (int j = 0; j < n; ++j) to[j] = fma(factor, from[j], to[j]);
  }
}

}  // namespace

void Preconditioner::resize(int n, int m) {
  for (std::vector<LaneNumbers>* matrix : {&inverse, &remainder, &work_}) matrix->resize(n * n);
  slopes.resize(n * m);
  scales_.resize(n);
  rows_.resize(n);
  single_.resize(n);
}

/// Finds Y with pivots that these lanes share. A pivot maximises the ratio |entry| / largest entry
/// of its row, of which the smallest among the lanes counts. Other lanes keep their Y.
template <int N>
void Preconditioner::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  const int n = N > 0 ? N : s.unknowns;
  LaneNumbers* const a = work_.data();
  for (int i = 0; i < n; ++i) {
    std::fill_n(a + i * n, n, LaneNumbers(0));
    LaneNumbers largest(0x1p-1000);
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) {
      a[i * n + s.entries[e]] = jacobian[e];
      largest = max(largest, abs(jacobian[e]));
    }
    if (n > 1) scales_[i] = LaneNumbers(1) / largest;
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    double best = -1;
    for (int i = k; i < n && k < n - 1; ++i) {
      const double score = smallest(abs(a[i * n + k]) * scales_[i], lanes);
      if (score > best) best = score, pivot = i;
    }
    rows_[k] = pivot;
    if (pivot != k) {
      std::swap(scales_[k], scales_[pivot]);
      std::swap_ranges(a + k * n, a + (k + 1) * n, a + pivot * n);
    }
    eliminate<N>(a, n, k);
  }
  // Rows were exchanged, so columns of the inverse are exchanged back.
  for (int k = n; k-- > 0;)
    if (rows_[k] != k)
      for (int i = 0; i < n; ++i) std::swap(a[i * n + k], a[i * n + rows_[k]]);
  for (int i = 0; i < n * n; ++i) inverse[i] = select(lanes, a[i], inverse[i]);
}

void Preconditioner::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  if (is_single_) return single_.invert(s, jacobian, inverse.data());
  with_unrolled_size(s.unknowns, [&]<int N>() { invert<N>(s, jacobian, lanes); });
}

/// Finds Y of three unknowns in all lanes by cofactors, without pivots.
void Preconditioner::invert_three(const BlockShape& s, const LaneNumbers* jacobian) {
  std::array<std::array<LaneNumbers, 3>, 3> a{};
  for (int i = 0; i < 3; ++i)
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) a[i][s.entries[e]] = jacobian[e];
  const auto cofactor = [&](int i, int j) {
    const auto &u = a[(i + 1) % 3], &v = a[(i + 2) % 3];
    const int k = (j + 1) % 3, l = (j + 2) % 3;
    return fma(u[k], v[l], -(u[l] * v[k]));
  };
  LaneNumbers determinant(0);
  for (int j = 0; j < 3; ++j) determinant = fma(a[0][j], cofactor(0, j), determinant);
  const LaneNumbers scale = LaneNumbers(1) / determinant;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) inverse[3 * j + i] = cofactor(i, j) * scale;
}

/// Finds |d − Y c| for a column c of Φ_q with Count entries. d has a 1 in row `one`, if that is
/// less than n, and else zeros.
template <int N, int Count>
void Preconditioner::multiply(const int* rows, const int* entries, const LaneNumbers* jacobian,
                              int size, int one, LaneNumbers* to, int stride) const {
  const int n = N > 0 ? N : size;
  std::array<const LaneNumbers*, Count> y;
  std::array<LaneNumbers, Count> factors;
  for (int k = 0; k < Count; ++k) {
    y[k] = &inverse[rows[k]];
    factors[k] = -jacobian[entries[k]];
  }
  const auto product = [&](int i, LaneNumbers sum) {
    for (int k = 0; k < Count; ++k) sum = fma(y[k][i * n], factors[k], sum);
    return abs(sum);
  };
  for (int i = 0; i < n; ++i) to[i * stride] = product(i, 0);
  if (one < n) to[one * stride] = product(one, 1);
}

/// Finds |D − Y C| for the columns first … last − 1 of Φ_q. D is I in the columns of unknowns, 0 in
/// those of inputs.
template <int N>
void Preconditioner::multiply(const BlockShape& s, const LaneNumbers* jacobian, int first, int last,
                              LaneNumbers* to) const {
  const int n = N > 0 ? N : s.unknowns, stride = last - first;
  for (int column = first; column < last; ++column, ++to) {
    const int begin = s.column_begins[column], count = s.column_begins[column + 1] - begin;
    const int *rows = &s.column_rows[begin], *entries = &s.column_entries[begin];
    const bool is_done = [&]<int... C>(std::integer_sequence<int, C...>) {
      return ((count == C + 1 &&
               (multiply<N, C + 1>(rows, entries, jacobian, n, column, to, stride), true)) ||
              ...);
    }
    (std::make_integer_sequence < int, N == 0 ? 6 : N > ());
    if (is_done) continue;
    for (int i = 0; i < n; ++i) {
      LaneNumbers sum(i == column ? 1 : 0);
      for (int k = 0; k < count; ++k)
        sum = fma(inverse[i * n + rows[k]], -jacobian[entries[k]], sum);
      to[i * stride] = abs(sum);
    }
  }
}

void Preconditioner::multiply(const BlockShape& s, const LaneNumbers* jacobian, int first, int last,
                              LaneNumbers* to) {
  if (is_single_) return single_.multiply(s, jacobian, first, last, to);
  with_unrolled_size(s.unknowns, [&]<int N>() { multiply<N>(s, jacobian, first, last, to); });
}

LaneNumbers Preconditioner::condition(const BlockShape& s, const LaneNumbers* jacobian,
                                      const LaneNumbers* magnitudes) {
  const int n = s.unknowns;
  for (int r = 0; r < n; ++r) {
    LaneNumbers sum(0);
    for (int e = s.row_begins[r]; e < s.row_begins[r + 1]; ++e)
      sum = fma(abs(jacobian[e]), magnitudes[s.entries[e]], sum);
    scales_[r] = sum;
  }
  LaneNumbers largest(0), all(0);
  for (int i = 0; i < n; ++i) {
    LaneNumbers sum(0);
    for (int r = 0; r < n; ++r) sum = fma(abs(inverse[i * n + r]), scales_[r], sum);
    largest = max(largest, sum / magnitudes[i]);
    all += sum;
  }
  return select(is_finite(all), largest, INFINITY);
}

void Preconditioner::find(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  is_single_ = s.unknowns > LaneNumbers::count &&
               std::all_of(jacobian, jacobian + s.row_begins[s.unknowns],
                           [](const LaneNumbers& x) { return x.are_same(); });
  s.unknowns == 3 ? invert_three(s, jacobian) : invert(s, jacobian, lanes);
  multiply(s, jacobian, 0, s.unknowns, remainder.data());
  if (s.unknowns > 1) {
    LaneNumbers worst(0);
    for (int i = 0; i < s.unknowns * s.unknowns; ++i) worst += remainder[i];
    // Below this sum, |I − Y Φ_φ| shrinks the first X, about first_trial, to less than a roundoff.
    constexpr double good = Interval::unit / first_trial;
    const LaneMask poor = lanes & !less(worst, good);
    if (poor.any()) {
      for (int lane = 0; lane < LaneNumbers::count; ++lane)
        if (poor[lane]) invert(s, jacobian, LaneMask::only(lane));
      multiply(s, jacobian, 0, s.unknowns, remainder.data());
    }
  }
  multiply(s, jacobian, s.unknowns, s.width(), slopes.data());
}

}  // namespace desmo
