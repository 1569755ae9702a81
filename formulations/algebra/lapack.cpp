// Dense LU with partial pivoting by LAPACK's getrf and getrs, as OpenBLAS provides them.

#include <type_traits>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/blas.h"
#include "formulations/algebra/dense.h"

extern "C" {
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda,
             const int* ipiv, double* b, const int* ldb, int* info);
void sgetrf_(const int* m, const int* n, float* a, const int* lda, int* ipiv, int* info);
void sgetrs_(const char* trans, const int* n, const int* nrhs, const float* a, const int* lda,
             const int* ipiv, float* b, const int* ldb, int* info);
char* openblas_get_config();
char* openblas_get_corename();
int openblas_get_num_threads();
void openblas_set_num_threads(int threads);
}

namespace desmo {

namespace {

template <class Real>
class Lapack {
 public:
  explicit Lapack(int n) : n_(n), lu_(static_cast<std::size_t>(n) * n), pivots_(n) {}

  Real* matrix() { return lu_.data(); }

  bool factor() {
    int info = 0;
    if constexpr (std::is_same_v<Real, double>)
      dgetrf_(&n_, &n_, lu_.data(), &n_, pivots_.data(), &info);
    else
      sgetrf_(&n_, &n_, lu_.data(), &n_, pivots_.data(), &info);
    return info == 0;
  }

  void solve(Real* b) {
    const int one = 1;
    int info = 0;
    if constexpr (std::is_same_v<Real, double>)
      dgetrs_("N", &n_, &one, lu_.data(), &n_, pivots_.data(), b, &n_, &info);
    else
      sgetrs_("N", &n_, &one, lu_.data(), &n_, pivots_.data(), b, &n_, &info);
  }

 private:
  int n_;
  std::vector<Real> lu_;  // by columns
  std::vector<int> pivots_;
};

}  // namespace

BlasEnvironment blas_environment() { return {openblas_get_corename(), openblas_get_num_threads()}; }

void set_blas_threads(int threads) { openblas_set_num_threads(threads); }

extern const Backend lapack_backend;
const Backend lapack_backend{.name = "lapack",
                             .dense = true,
                             .make_solver = &make_dense_solver<Lapack>,
                             .version = [] { return std::string(openblas_get_config()); },
                             .make_single_solver = &make_single_dense_solver<Lapack>};

}  // namespace desmo
