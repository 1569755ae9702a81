// Dense LU with partial pivoting by LAPACK's getrf and getrs, as OpenBLAS provides them.

#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/blas.h"
#include "formulations/algebra/dense.h"

extern "C" {
void dgetrf_(const int* m, const int* n, double* a, const int* lda, int* ipiv, int* info);
void dgetrs_(const char* trans, const int* n, const int* nrhs, const double* a, const int* lda,
             const int* ipiv, double* b, const int* ldb, int* info);
char* openblas_get_config();
char* openblas_get_corename();
int openblas_get_num_threads();
void openblas_set_num_threads(int threads);
}

namespace desmo {

namespace {

class Lapack {
 public:
  explicit Lapack(int n) : n_(n), lu_(static_cast<std::size_t>(n) * n), pivots_(n) {}

  double* matrix() { return lu_.data(); }

  bool factor() {
    int info = 0;
    dgetrf_(&n_, &n_, lu_.data(), &n_, pivots_.data(), &info);
    return info == 0;
  }

  void solve(double* b) {
    const int one = 1;
    int info = 0;
    dgetrs_("N", &n_, &one, lu_.data(), &n_, pivots_.data(), b, &n_, &info);
  }

 private:
  int n_;
  std::vector<double> lu_;  // the matrix by columns, then its factors
  std::vector<int> pivots_;
};

}  // namespace

BlasEnvironment blas_environment() { return {openblas_get_corename(), openblas_get_num_threads()}; }

void set_blas_threads(int threads) { openblas_set_num_threads(threads); }

extern const Backend lapack_backend{
    .name = "lapack", .dense = true, .make_solver = &make_solver<Dense<Lapack>>, .version = [] {
      return std::string(openblas_get_config());
    }};

}  // namespace desmo
