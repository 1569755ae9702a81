#include "formulations/verification/certificate/preconditioner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "cases/numbers/interval.h"
#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

namespace {

constexpr int lane_count = LaneNumbers::count;

/// Returns the number of registers that n doubles take.
int registers(int n) { return (n + lane_count - 1) / lane_count; }

// An entry S of a row is a register, one number for each lane, or a double in all lanes.
template <class S>
S entry(const double* row, int k) {
  if constexpr (std::is_same_v<S, double>)
    return row[k];
  else
    return LaneNumbers::load(row + lane_count * k);
}
void set_entry(double* row, int k, double x) { row[k] = x; }
void set_entry(double* row, int k, const LaneNumbers& x) { x.store(row + lane_count * k); }
bool is_none(double x) { return x == 0; }
bool is_none(const LaneNumbers& x) { return !(!is_zero(x)).any(); }

/// Returns the smallest number in the given lanes.
double smallest(double x, LaneMask) { return x; }
double smallest(const LaneNumbers& x, LaneMask lanes) {
  const LaneNumbers y = select(lanes, x, INFINITY);
  return std::min(std::min(y[0], y[1]), std::min(y[2], y[3]));
}

}  // namespace

void Preconditioner::resize(int n, int m) {
  for (std::vector<LaneNumbers>* matrix : {&inverse, &remainder}) matrix->resize(n * n);
  slopes.resize(n * m);
  columns_.resize((n + 1) * registers(n));
  work_.resize(lane_count * n * n);
  scales_.resize(lane_count * n);
  rows_.resize(n);
}

/// Finds Y by Gauss–Jordan elimination, with pivots that these lanes share. A pivot maximises the
/// ratio |entry| / largest entry of its row, of which the smallest among the lanes counts. Other
/// lanes keep their Y. S: double if all lanes have the same matrix.
template <class S, int N>
void Preconditioner::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  using std::abs, std::max;
  constexpr bool is_single = std::is_same_v<S, double>;
  const int n = N > 0 ? N : s.unknowns;
  const int size = lane_count * (is_single ? registers(n) : n);  // of a row
  double *const all = work_.data(), *const end = all + n * size, *const scales = scales_.data();
  for (int i = 0; i < n; ++i) {
    double* const row = all + i * size;
    std::fill_n(row, size, 0);
    S largest(0x1p-1000);
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) {
      const S x = entry<S>(&jacobian[e].v[0], 0);
      set_entry(row, s.entries[e], x);
      largest = max(largest, abs(x));
    }
    if (n > 1) set_entry(scales, i, S(1) / largest);
  }
  for (int k = 0; k < n; ++k) {
    double* const from = all + k * size;
    int pivot = k;
    double best = -1;
    const double* row = from;
    for (int i = k; i < n && k < n - 1; ++i, row += size) {
      const double score = smallest(abs(entry<S>(row, k)) * entry<S>(scales, i), lanes);
      if (score > best) best = score, pivot = i;
    }
    rows_[k] = pivot;
    if (pivot != k) {
      set_entry(scales, pivot, entry<S>(scales, k));
      std::swap_ranges(from, from + size, all + pivot * size);
    }
    const LaneNumbers scale(S(1) / entry<S>(from, k));
    set_entry(from, k, S(1));
    for (int j = 0; j < size; j += lane_count)
      (LaneNumbers::load(from + j) * scale).store(from + j);
    for (double* to = all; to < end; to += size) {
      if (to == from) continue;
      const S factor = -entry<S>(to, k);
      if (N == 0 && is_none(factor)) continue;
      set_entry(to, k, S(0));
#pragma GCC unroll 4
      for (int j = 0; j < size; j += lane_count)
        fma(LaneNumbers(factor), LaneNumbers::load(from + j), LaneNumbers::load(to + j))
            .store(to + j);
    }
  }
  // Rows were exchanged, so columns of the inverse are exchanged back.
  for (int k = n; k-- > 0;)
    if (const int other = rows_[k]; other != k)
      for (double* row = all; row < end; row += size) {
        const S x = entry<S>(row, k);
        set_entry(row, k, entry<S>(row, other));
        set_entry(row, other, x);
      }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const S x = entry<S>(all + i * size, j);
      inverse[i * n + j] = select(lanes, x, inverse[i * n + j]);
      if constexpr (is_single) columns_[j * registers(n) + i / lane_count].set(i % lane_count, x);
    }
}

void Preconditioner::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneMask lanes) {
  if (is_single_) return invert<double, 0>(s, jacobian, lanes);
  with_unrolled_size(s.unknowns, [&]<int N>() { invert<LaneNumbers, N>(s, jacobian, lanes); });
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

/// Finds the same where all lanes have the same matrix.
void Preconditioner::multiply_single(const BlockShape& s, const LaneNumbers* jacobian, int first,
                                     int last, LaneNumbers* to) {
  const int n = s.unknowns, size = registers(n), stride = last - first;
  LaneNumbers* const product = &columns_[n * size];
  for (int column = first; column < last; ++column, ++to) {
    std::fill_n(product, size, LaneNumbers(0));
    if (column < n) product[column / lane_count].set(column % lane_count, 1);
    for (int k = s.column_begins[column]; k < s.column_begins[column + 1]; ++k) {
      const LaneNumbers factor = -jacobian[s.column_entries[k]];
      const LaneNumbers* const y = &columns_[s.column_rows[k] * size];
#pragma GCC unroll 4
      for (int i = 0; i < size; ++i) product[i] = fma(factor, y[i], product[i]);
    }
    for (int i = 0; i < n; ++i) to[i * stride] = std::abs(product[i / lane_count][i % lane_count]);
  }
}

void Preconditioner::multiply(const BlockShape& s, const LaneNumbers* jacobian, int first, int last,
                              LaneNumbers* to) {
  if (is_single_) return multiply_single(s, jacobian, first, last, to);
  with_unrolled_size(s.unknowns, [&]<int N>() { multiply<N>(s, jacobian, first, last, to); });
}

LaneNumbers Preconditioner::condition(const BlockShape& s, const LaneNumbers* jacobian,
                                      const LaneNumbers* magnitudes) {
  const int n = s.unknowns;
  for (int r = 0; r < n; ++r) {
    LaneNumbers sum(0);
    for (int e = s.row_begins[r]; e < s.row_begins[r + 1]; ++e)
      sum = fma(abs(jacobian[e]), magnitudes[s.entries[e]], sum);
    set_entry(scales_.data(), r, sum);
  }
  LaneNumbers largest(0), all(0);
  for (int i = 0; i < n; ++i) {
    LaneNumbers sum(0);
    for (int r = 0; r < n; ++r)
      sum = fma(abs(inverse[i * n + r]), entry<LaneNumbers>(scales_.data(), r), sum);
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
