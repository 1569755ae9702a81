#include "formulations/verification/certificate/preconditioner.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace desmo {

namespace {

/// Smallest number in some lanes; zero where one of them is not a number.
double smallest(const Lanes& x, LaneMask lanes) {
  const Lanes y = select(lanes, x, INFINITY);
  const double low = std::min(y[0], y[1]), high = std::min(y[2], y[3]);
  return std::min(low, high);
}

/// Calls function<N>() with the size where it is small, for loops to unroll; otherwise with N = 0.
template <class Function>
void with_size(int n, Function&& function) {
  if (n == 1)
    function.template operator()<1>();
  else if (n == 3)
    function.template operator()<3>();
  else
    function.template operator()<0>();
}

template <int N>
void find_remainder(const Lanes* inverse, const Lanes* jacobian, int size, int w, Lanes* to) {
  const int n = N > 0 ? N : size;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      Lanes rest(i == j ? 1 : 0);
      for (int r = 0; r < n; ++r) rest -= inverse[i * n + r] * jacobian[r * w + j];
      to[i * n + j] = abs(rest);
    }
}

template <int N>
void find_slopes(const Lanes* inverse, const Lanes* jacobian, int size, int m, Lanes* to) {
  const int n = N > 0 ? N : size, w = n + m;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < m; ++j) {
      Lanes slope(0);
      for (int r = 0; r < n; ++r) slope += inverse[i * n + r] * jacobian[r * w + n + j];
      to[i * m + j] = abs(slope);
    }
}

}  // namespace

void Preconditioner::resize(int n, int m) {
  for (std::vector<Lanes>* matrix : {&inverse, &remainder, &work}) matrix->resize(n * n);
  slopes.resize(n * m);
  scales.resize(n);
  rows.resize(n);
}

/// Gauss–Jordan elimination in place, with pivots that are large in their rows in all these lanes.
void Preconditioner::invert(const Lanes* jacobian, int n, int w, LaneMask lanes) {
  Lanes* a = work.data();
  for (int i = 0; i < n; ++i) {
    std::copy_n(jacobian + i * w, n, a + i * n);
    Lanes largest(0x1p-1000);
    for (int j = 0; j < n; ++j) largest = max(largest, abs(a[i * n + j]));
    scales[i] = Lanes(1) / largest;
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    double best = -1;
    for (int i = k; i < n && k < n - 1; ++i) {
      const double score = smallest(abs(a[i * n + k]) * scales[i], lanes);
      if (score > best) best = score, pivot = i;
    }
    rows[k] = pivot;
    if (pivot != k) {
      std::swap(scales[k], scales[pivot]);
      std::swap_ranges(a + k * n, a + (k + 1) * n, a + pivot * n);
    }
    const Lanes scale = Lanes(1) / a[k * n + k];
    a[k * n + k] = 1;
    for (int j = 0; j < n; ++j) a[k * n + j] *= scale;
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const Lanes factor = a[i * n + k];
      a[i * n + k] = 0;
      for (int j = 0; j < n; ++j) a[i * n + j] -= factor * a[k * n + j];
    }
  }
  for (int k = n; k-- > 0;)
    if (rows[k] != k)
      for (int i = 0; i < n; ++i) std::swap(a[i * n + k], a[i * n + rows[k]]);
  for (int i = 0; i < n * n; ++i) inverse[i] = select(lanes, a[i], inverse[i]);
}

void Preconditioner::find(const Lanes* jacobian, int n, int m, LaneMask lanes) {
  const auto find_remainder_of = [&] {
    with_size(n, [&]<int N>() {
      find_remainder<N>(inverse.data(), jacobian, n, n + m, remainder.data());
    });
  };
  invert(jacobian, n, n + m, lanes);
  find_remainder_of();
  if (n > 1) {
    Lanes worst(0);
    for (int i = 0; i < n * n; ++i) worst = worst + remainder[i];
    constexpr double good = 1e-6;
    const LaneMask poor = lanes & !less(worst, good);
    if (poor.any()) {
      for (int lane = 0; lane < Lanes::count; ++lane)
        if (poor[lane]) invert(jacobian, n, n + m, LaneMask::only(lane));
      find_remainder_of();
    }
  }
  with_size(n, [&]<int N>() { find_slopes<N>(inverse.data(), jacobian, n, m, slopes.data()); });
}

}  // namespace desmo
