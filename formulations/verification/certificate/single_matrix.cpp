#include "formulations/verification/certificate/single_matrix.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace desmo {

namespace {

constexpr int count = LaneNumbers::count;

int rounded_up(int n) { return (n + count - 1) / count * count; }

/// Adds factor × x to y. size: a multiple of LaneNumbers::count.
void add_product(double factor, const double* x, int size, double* y) {
  const LaneNumbers f(factor);
#pragma GCC unroll 4
  for (int j = 0; j < size; j += count)
    fma(f, LaneNumbers::load(x + j), LaneNumbers::load(y + j)).store(y + j);
}

}  // namespace

void SingleMatrix::resize(int n) {
  const int stride = rounded_up(n);
  rows_.resize(n * stride);
  columns_.resize(n * stride);
  for (std::vector<int>* positions : {&order_, &pivots_}) positions->resize(n);
  scales_.resize(n);
  product_.resize(stride);
}

void SingleMatrix::invert(const BlockShape& s, const LaneNumbers* jacobian, LaneNumbers* inverse) {
  const int n = n_ = s.unknowns, stride = stride_ = rounded_up(n);
  for (int i = 0; i < n; ++i) {
    double* const to = &rows_[i * stride];
    std::fill_n(to, stride, 0);
    double largest = 0x1p-1000;
    for (int e = s.row_begins[i]; e < s.input_begins[i]; ++e) {
      to[s.entries[e]] = jacobian[e][0];
      largest = std::max(largest, std::abs(jacobian[e][0]));
    }
    scales_[i] = 1 / largest;
  }
  double* const all = rows_.data();
  double* const end = all + n * stride;
  for (int k = 0; k < n; ++k) {
    double* const from = all + k * stride;
    const double* row = from + k;
    int pivot = k;
    double best = -1;
    for (int i = k; i < n; ++i, row += stride)
      if (const double score = std::abs(*row) * scales_[i]; score > best) best = score, pivot = i;
    pivots_[k] = pivot;
    if (pivot != k) {
      std::swap(scales_[k], scales_[pivot]);
      std::swap_ranges(from, from + stride, all + pivot * stride);
    }
    const double scale = 1 / from[k];
    from[k] = 1;
    for (int j = 0; j < stride; ++j) from[j] *= scale;
    for (double* to = all; to < end; to += stride) {
      const double factor = to[k];
      if (factor == 0 || to == from) continue;
      to[k] = 0;
      add_product(-factor, from, stride, to);
    }
  }
  write_inverse(inverse);
}

void SingleMatrix::write_inverse(LaneNumbers* to) {
  // Rows were exchanged, so columns of the inverse are in another order.
  std::iota(order_.begin(), order_.begin() + n_, 0);
  for (int k = n_; k-- > 0;) std::swap(order_[k], order_[pivots_[k]]);
  const int n = n_, stride = stride_, *const order = order_.data();
  const double* row = rows_.data();
  double* columns = columns_.data();
  for (int i = 0; i < n; ++i, row += stride, ++columns)
    for (int j = 0; j < n; ++j) *to++ = columns[j * stride] = row[order[j]];
}

void SingleMatrix::multiply(const BlockShape& s, const LaneNumbers* jacobian, int first, int last,
                            LaneNumbers* to) {
  const int stride = last - first;
  for (int column = first; column < last; ++column, ++to) {
    std::fill_n(product_.begin(), stride_, 0);
    if (column < n_) product_[column] = 1;
    for (int k = s.column_begins[column]; k < s.column_begins[column + 1]; ++k)
      add_product(-jacobian[s.column_entries[k]][0], &columns_[s.column_rows[k] * stride_], stride_,
                  product_.data());
    for (int i = 0; i < n_; ++i) to[i * stride] = std::abs(product_[i]);
  }
}

}  // namespace desmo
