// Sparse LU by SuiteSparse's UMFPACK (GPL). Analysis is done once. There is no numeric
// refactorisation: every factorisation pivots anew and allocates.

#include <umfpack.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

namespace {

class Umfpack final : public LinearSolver {
 public:
  explicit Umfpack(const Pattern& pattern)
      : n_(pattern.n),
        start_(pattern.column_start),
        row_(pattern.row),
        right_(n_),
        work_(n_),
        index_work_(n_) {
    umfpack_di_defaults(control_);
    control_[UMFPACK_IRSTEP] = 0;  // no iterative refinement: Newton's method refines
    control_[UMFPACK_SCALE] = UMFPACK_SCALE_NONE;  // these matrices need no scaling
    control_[UMFPACK_FIXQ] = 1;  // fronts this small do not repay a search for better columns
    // twice the estimated memory at once, so that it need not grow
    control_[UMFPACK_ALLOC_INIT] = 2;
    if (umfpack_di_symbolic(n_, n_, start_.data(), row_.data(), nullptr, &symbolic_, control_,
                            nullptr) != UMFPACK_OK)
      throw std::invalid_argument("UMFPACK: the Jacobian could not be analysed");
  }
  ~Umfpack() override {
    umfpack_di_free_numeric(&numeric_);
    umfpack_di_free_symbolic(&symbolic_);
  }

  bool factor(const double* values) override {
    umfpack_di_free_numeric(&numeric_);
    values_ = values;
    return umfpack_di_numeric(start_.data(), row_.data(), values, symbolic_, &numeric_, control_,
                              nullptr) == UMFPACK_OK;
  }

  void solve(double* b) override {
    std::copy_n(b, n_, right_.begin());
    umfpack_di_wsolve(UMFPACK_A, start_.data(), row_.data(), values_, b, right_.data(), numeric_,
                      control_, nullptr, index_work_.data(), work_.data());
  }

 private:
  int n_;
  std::vector<int> start_, row_;
  std::vector<double> right_, work_;
  std::vector<int> index_work_;
  const double* values_ = nullptr;  // values of Φ_φ that were factorised last
  double control_[UMFPACK_CONTROL];
  void* symbolic_ = nullptr;
  void* numeric_ = nullptr;
};

}  // namespace

extern const Backend umfpack_backend{
    .name = "umfpack",
    .make_solver = &make_solver<Umfpack>,
    .version =
        [] {
          return version_text(UMFPACK_MAIN_VERSION, UMFPACK_SUB_VERSION, UMFPACK_SUBSUB_VERSION);
        },
    .allocates = true,
    .slow_blocks_reason = slow_in_blocks};

}  // namespace desmo
