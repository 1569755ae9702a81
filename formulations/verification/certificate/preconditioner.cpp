#include "formulations/verification/certificate/preconditioner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

namespace {

/// Returns the smallest number in some lanes.
double smallest(const LaneNumbers& x, LaneMask lanes) {
  const LaneNumbers y = select(lanes, x, INFINITY);
  return std::min(std::min(y[0], y[1]), std::min(y[2], y[3]));
}

/// Gauss–Jordan elimination of row k and column k, in place.
template <int N>
void eliminate(LaneNumbers* a, int size, int k) {
  const int n = N > 0 ? N : size;
  const LaneNumbers scale = LaneNumbers(1) / a[k * n + k];
  a[k * n + k] = 1;
  for (int j = 0; j < n; ++j) a[k * n + j] *= scale;
  for (int i = 0; i < n; ++i) {
    if (i == k) continue;
    const LaneNumbers factor = -a[i * n + k];
    if (N == 0 && !(!is_zero(factor)).any()) continue;
    a[i * n + k] = 0;
#pragma GCC unroll 4
    for (int j = 0; j < n; ++j) a[i * n + j] = fma(factor, a[k * n + j], a[i * n + j]);
  }
}

}  // namespace

void Preconditioner::resize(int n, int m) {
  for (std::vector<LaneNumbers>* matrix : {&inverse, &remainder, &work_}) matrix->resize(n * n);
  slopes.resize(n * m);
  scales_.resize(n);
  rows_.resize(n);
}

/// Inverts the matrix of a single block, which all lanes have. A register has columns of a row.
void Preconditioner::invert_single(const BlockShape& s, const LaneNumbers* jacobian) {
  constexpr int count = LaneNumbers::count;
  const int n = s.unknowns, width = (n + count - 1) / count;
  LaneNumbers* a = work_.data();
  const auto entry = [&](int i, int j) { return a[i * width + j / count][j % count]; };
  std::fill_n(a, n * width, LaneNumbers(0));
  for (int i = 0; i < n; ++i) {
    double largest = 0x1p-1000;
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) {
      const int j = s.entries[e];
      a[i * width + j / count].set(j % count, jacobian[e][0]);
      largest = std::max(largest, std::abs(jacobian[e][0]));
    }
    scales_[i] = 1 / largest;
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    double best = -1;
    for (int i = k; i < n; ++i)
      if (const double score = std::abs(entry(i, k)) * scales_[i][0]; score > best)
        best = score, pivot = i;
    rows_[k] = pivot;
    LaneNumbers* const row = a + k * width;
    if (pivot != k) {
      std::swap(scales_[k], scales_[pivot]);
      std::swap_ranges(row, row + width, a + pivot * width);
    }
    const LaneNumbers scale = 1 / entry(k, k);
    row[k / count].set(k % count, 1);
    for (int j = 0; j < width; ++j) row[j] *= scale;
    for (int i = 0; i < n; ++i) {
      const double factor = -entry(i, k);
      if (i == k || factor == 0) continue;
      LaneNumbers* const to = a + i * width;
      to[k / count].set(k % count, 0);
      for (int j = 0; j < width; ++j) to[j] = fma(factor, row[j], to[j]);
    }
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) inverse[i * n + j] = entry(i, j);
  swap_columns(n, inverse.data());
}

/// Puts the columns of an inverse in their places, after rows were exchanged.
void Preconditioner::swap_columns(int n, LaneNumbers* a) const {
  for (int k = n; k-- > 0;)
    if (rows_[k] != k)
      for (int i = 0; i < n; ++i) std::swap(a[i * n + k], a[i * n + rows_[k]]);
}

/// Finds Y with pivots that are large in their rows in all these lanes.
void Preconditioner::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  const int n = s.unknowns;
  if (n > LaneNumbers::count &&
      std::all_of(jacobian, jacobian + s.row_begins[n], [](auto& x) { return x.are_same(); }))
    return invert_single(s, jacobian);
  LaneNumbers* a = work_.data();
  std::fill_n(a, n * n, LaneNumbers(0));
  for (int i = 0; i < n; ++i) {
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
    n == 3 ? eliminate<3>(a, n, k) : eliminate<0>(a, n, k);
  }
  swap_columns(n, a);
  for (int i = 0; i < n * n; ++i) inverse[i] = select(lanes, a[i], inverse[i]);
}

/// Finds |D − Y c| for a column c of Φ_q, where D has a 1 in row `one` and zeros elsewhere.
void Preconditioner::multiply(const BlockShape& s, const LaneNumbers* jacobian, int column, int one,
                              LaneNumbers* to, int stride) const {
  const int begin = s.column_begins[column], count = s.column_begins[column + 1] - begin;
  const int* rows = &s.column_rows[begin];
  const auto with = [&]<int Count>() {
    std::array<const LaneNumbers*, Count> y;
    std::array<LaneNumbers, Count> minus;
    for (int k = 0; k < Count; ++k) {
      y[k] = &inverse[rows[k]];
      minus[k] = -jacobian[s.column_entries[begin + k]];
    }
    const int n = s.unknowns;
    for (int i = 0; i < n; ++i) {
      LaneNumbers sum(i == one ? 1 : 0);
      for (int k = 0; k < Count; ++k) sum = fma(y[k][i * n], minus[k], sum);
      to[i * stride] = abs(sum);
    }
  };
  switch (count) {
    case 1:
      return with.template operator()<1>();
    case 2:
      return with.template operator()<2>();
    case 3:
      return with.template operator()<3>();
    case 4:
      return with.template operator()<4>();
    default:
      break;
  }
  const int n = s.unknowns;
  for (int i = 0; i < n; ++i) {
    LaneNumbers sum(i == one ? 1 : 0);
    for (int k = 0; k < count; ++k)
      sum = fma(inverse[i * n + rows[k]], -jacobian[s.column_entries[begin + k]], sum);
    to[i * stride] = abs(sum);
  }
}

void Preconditioner::find_remainder(const BlockShape& s, const LaneNumbers* jacobian) {
  for (int j = 0; j < s.unknowns; ++j) multiply(s, jacobian, j, j, &remainder[j], s.unknowns);
}

void Preconditioner::find_slopes(const BlockShape& s, const LaneNumbers* jacobian) {
  for (int j = 0; j < s.inputs; ++j)
    multiply(s, jacobian, s.unknowns + j, -1, &slopes[j], s.inputs);
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
  invert(s, jacobian, lanes);
  find_remainder(s, jacobian);
  if (s.unknowns > 1) {
    LaneNumbers worst(0);
    for (int i = 0; i < s.unknowns * s.unknowns; ++i) worst += remainder[i];
    // What the remainder leaves of a first X is then less than a unit.
    constexpr double good = Interval::unit / first_trial;
    const LaneMask poor = lanes & !less(worst, good);
    if (poor.any()) {
      for (int lane = 0; lane < LaneNumbers::count; ++lane)
        if (poor[lane]) invert(s, jacobian, LaneMask::only(lane));
      find_remainder(s, jacobian);
    }
  }
  find_slopes(s, jacobian);
}

}  // namespace desmo
