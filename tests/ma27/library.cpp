// A library with the entries of HSL's MA27 and none of its code, which may not be distributed:
// dense LDLᵀ without pivoting, at the same interface. It is strict about what it is handed,
// allocates nothing, and asks for less memory at first than it then says it needs. Built without
// one entry, or as one that says that it does nothing, it is a library that does not serve.

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace {

constexpr int integers_asked = 1;  // at first

void require(bool condition) {
  if (!condition) std::abort();
}

void clear(int* info) { std::fill_n(info, 20, 0); }

void fail(int* info, int status, int detail) {
  info[0] = status;
  info[1] = detail;
}

/// Leaves D and L below it in a (columns of n). The place of a pivot that is none, or n.
[[maybe_unused]] int eliminate(double* a, int n, double least) {
  for (int k = 0; k < n; ++k) {
    const double pivot = a[k + k * n];
    if (pivot == 0 || std::abs(pivot) < least) return k;
    for (int j = k + 1; j < n; ++j) {
      const double factor = a[j + k * n] / pivot;
      for (int i = j; i < n; ++i) a[i + j * n] -= factor * a[i + k * n];
    }
    for (int i = k + 1; i < n; ++i) a[i + k * n] /= pivot;
  }
  return n;
}

}  // namespace

extern "C" {

void LIBHSL_version(int* major, int* minor, int* patch) {
  *major = 1;
  *minor = 2;
  *patch = 3;
}

void ma27id_(int* icntl, double* cntl) {
  std::fill_n(icntl, 30, 6);
  std::fill_n(cntl, 5, 0.0);
  cntl[0] = 0.1;
}

void ma27ad_(const int* n, const int* nz, const int* irn, const int* icn, int* iw, const int* liw,
             int* ikeep, int* iw1, int* nsteps, int* iflag, const int* icntl, const double*,
             int* info, double* ops) {
  clear(info);
  require(*iflag == 0 && icntl[0] == 0 && icntl[1] == 0);
  for (int k = 0; k < *nz; ++k) require(1 <= irn[k] && irn[k] <= *n && 1 <= icn[k] && icn[k] <= *n);
  const int needed = 20 * (2 * *nz + 3 * *n + 1);
  if (*liw < needed) return fail(info, -3, needed);
  std::fill_n(iw, *liw, 0);
  std::fill_n(iw1, 2 * *n, 0);
  for (int k = 0; k < 3 * *n; ++k) ikeep[k] = k;
  *nsteps = *n;
  *ops = *nz;
  info[2] = info[4] = *nz;
  info[3] = info[5] = integers_asked;
}

#ifndef DESMO_WITHOUT_MA27BD
void ma27bd_(const int* order, const int* nz, const int* irn, const int* icn, double* a,
             const int* la, int* iw, const int* liw, const int* ikeep, const int* nsteps,
             int* maxfrt, int* iw1, const int*, const double* cntl, int* info) {
  clear(info);
  const int n = *order, reals = n * n + *nz, integers = 2 * n;
  for (int k = 0; k < 3 * n; ++k) require(ikeep[k] == k);
  require(*nsteps == n && *la >= *nz && cntl[0] == 0);
  a[0] = *liw < integers || *la < reals ? -1 : a[0];  // what it held is not to be counted on
  if (*liw < integers) return fail(info, -3, integers);
  if (*la < reals) return fail(info, -4, reals);
  std::fill_n(iw, integers, n);
  std::fill_n(iw1, n, 0);
  *maxfrt = n;
  double* const entries = a + n * n;
  std::copy_backward(a, a + *nz, entries + *nz);
  std::fill_n(a, n * n, 0.0);
  for (int k = 0; k < *nz; ++k) {
    const auto [low, high] = std::minmax(irn[k], icn[k]);
    a[high - 1 + (low - 1) * n] += entries[k];
  }
  if (const int zero = eliminate(a, n, cntl[2]); zero < n) return fail(info, -5, zero + 1);
  int negative = 0;
  for (int k = 0; k < n; ++k) negative += a[k + k * n] < 0;
  info[14] = negative;
  if (negative > 0 && negative < n) fail(info, 2, negative);
}
#endif

void ma27cd_(const int* order, const double* a, const int* la, const int* iw, const int* liw,
             double* w, const int* maxfrt, double* rhs, int* iw1, const int* nsteps, const int*,
             int* info) {
  clear(info);
  const int n = *order;
  require(*maxfrt == n && *la >= n * n && *liw >= 2 * n && iw[0] == n);
  std::fill_n(w, *maxfrt, 0.0);
  std::fill_n(iw1, *nsteps, 0);
  for (int k = 0; k < n; ++k)
    for (int i = k + 1; i < n; ++i) rhs[i] -= a[i + k * n] * rhs[k];
  for (int k = n - 1; k >= 0; --k) {
    rhs[k] /= a[k + k * n];
    for (int i = k + 1; i < n; ++i) rhs[k] -= a[i + k * n] * rhs[i];
  }
}

#ifdef DESMO_MA27_DUMMY
bool LIBHSL_isfunctional() { return false; }
#endif

}  // extern "C"
