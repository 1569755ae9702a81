#include "formulations/verification/certificate/preconditioner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace desmo {

namespace {

/// Returns the smallest number in some lanes.
double smallest(const Lanes& x, LaneMask lanes) {
  const Lanes y = select(lanes, x, INFINITY);
  return std::min(std::min(y[0], y[1]), std::min(y[2], y[3]));
}

/// Gauss–Jordan elimination of row k and column k, in place.
template <int N>
void eliminate(Lanes* a, int size, int k) {
  const int n = N > 0 ? N : size;
  const Lanes scale = Lanes(1) / a[k * n + k];
  a[k * n + k] = 1;
  for (int j = 0; j < n; ++j) a[k * n + j] *= scale;
  for (int i = 0; i < n; ++i) {
    if (i == k) continue;
    const Lanes factor = -a[i * n + k];
    a[i * n + k] = 0;
    for (int j = 0; j < n; ++j) a[i * n + j] = fma(factor, a[k * n + j], a[i * n + j]);
  }
}

}  // namespace

void Preconditioner::resize(int n, int m) {
  for (std::vector<Lanes>* matrix : {&inverse, &remainder, &work_}) matrix->resize(n * n);
  slopes.resize(n * m);
  scales_.resize(n);
  rows_.resize(n);
}

/// Finds Y with pivots that are large in their rows in all these lanes.
void Preconditioner::invert(const BlockShape& s, const Lanes* jacobian, LaneMask lanes) {
  const int n = s.unknowns;
  Lanes* a = work_.data();
  std::fill_n(a, n * n, Lanes(0));
  for (int i = 0; i < n; ++i) {
    Lanes largest(0x1p-1000);
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) {
      a[i * n + s.entries[e]] = jacobian[e];
      largest = max(largest, abs(jacobian[e]));
    }
    if (n > 1) scales_[i] = Lanes(1) / largest;
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
  for (int k = n; k-- > 0;)
    if (rows_[k] != k)
      for (int i = 0; i < n; ++i) std::swap(a[i * n + k], a[i * n + rows_[k]]);
  for (int i = 0; i < n * n; ++i) inverse[i] = select(lanes, a[i], inverse[i]);
}

void Preconditioner::find_remainder(const BlockShape& s, const Lanes* jacobian) {
  const int n = s.unknowns;
  for (int i = 0; i < n; ++i) {
    Lanes* rest = &remainder[i * n];
    for (int j = 0; j < n; ++j) rest[j] = i == j ? 1 : 0;
    for (int r = 0; r < n; ++r) {
      const Lanes y = -inverse[i * n + r];
      for (int e = s.row_begins[r]; e < s.input_begins[r]; ++e)
        rest[s.entries[e]] = fma(y, jacobian[e], rest[s.entries[e]]);
    }
    for (int j = 0; j < n; ++j) rest[j] = abs(rest[j]);
  }
}

void Preconditioner::find_slopes(const BlockShape& s, const Lanes* jacobian) {
  const int n = s.unknowns, m = s.inputs;
  for (int i = 0; i < n; ++i) {
    Lanes* to = slopes.data() + i * m;
    std::fill_n(to, m, Lanes(0));
    for (int r = 0; r < n; ++r)
      for (int e = s.input_begins[r]; e < s.row_begins[r + 1]; ++e) {
        Lanes& slope = to[s.entries[e] - n];
        slope = fma(inverse[i * n + r], jacobian[e], slope);
      }
    for (int j = 0; j < m; ++j) to[j] = abs(to[j]);
  }
}

void Preconditioner::find(const BlockShape& s, const Lanes* jacobian, LaneMask lanes) {
  invert(s, jacobian, lanes);
  find_remainder(s, jacobian);
  if (s.unknowns > 1) {
    Lanes worst(0);
    for (int i = 0; i < s.unknowns * s.unknowns; ++i) worst += remainder[i];
    constexpr double good = 1e-6;
    const LaneMask poor = lanes & !less(worst, good);
    if (poor.any()) {
      for (int lane = 0; lane < Lanes::count; ++lane)
        if (poor[lane]) invert(s, jacobian, LaneMask::only(lane));
      find_remainder(s, jacobian);
    }
  }
  find_slopes(s, jacobian);
}

}  // namespace desmo
