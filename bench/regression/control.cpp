#include "bench/regression/control.h"

namespace desmo::regression {

namespace {

constexpr int size = 32, sweeps = 300;

/// On a page of its own, like the code below: where a build happens to put them must not show.
struct alignas(4096) Data {
  double a[size][size];
  double x[size], y[size];
} data;

}  // namespace

// x ← A x / 2 with rows that sum to 2: x stays near 1, neither vanishing nor overflowing.
__attribute__((noinline, aligned(4096))) double control_kernel() {
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) data.a[i][j] = 1.0 / size + (i == j ? 1.0 : 0.0);
    data.x[i] = 1 + i;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < size; ++i) {
      double sum = 0;
      for (int j = 0; j < size; ++j) sum += data.a[i][j] * data.x[j];
      data.y[i] = sum / 2;
    }
    for (int i = 0; i < size; ++i) data.x[i] = data.y[i];
  }
  return data.x[0];
}

}  // namespace desmo::regression
