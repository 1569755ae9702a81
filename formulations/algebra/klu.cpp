// Sparse LU by SuiteSparse's KLU: block triangular form and ordering once, then numeric
// refactorisation in the pivot order of the last full factorisation.

#include <klu.h>

#include <Eigen/Core>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

namespace {

class Klu {
 public:
  static constexpr bool rounds_factors = false;
  static constexpr bool keeps_pivots = true;

  explicit Klu(const Pattern& pattern)
      : n_(pattern.n), start_(pattern.column_start), row_(pattern.row) {
    klu_defaults(&common_);
    common_.scale = -1;  // row scaling costs a tenth and these matrices need none
    // The pivot order has to last: with the default, 0.001, a pivot may be so small that the
    // mechanism's motion takes it through zero.
    common_.tol = 0.1;
    symbolic_ = klu_analyze(n_, start_.data(), row_.data(), &common_);
    if (!symbolic_) throw std::invalid_argument("KLU: the Jacobian is structurally singular");
  }
  Klu(const Klu&) = delete;
  Klu& operator=(const Klu&) = delete;
  ~Klu() {
    klu_free_numeric(&numeric_, &common_);
    klu_free_symbolic(&symbolic_, &common_);
  }

  bool factor(const double* values) {
    double* ax = const_cast<double*>(values);  // KLU reads them only
    if (numeric_ && klu_refactor(start_.data(), row_.data(), ax, symbolic_, numeric_, &common_) &&
        pivots_are_good())
      return true;
    forget_pivots();
    numeric_ = klu_factor(start_.data(), row_.data(), ax, symbolic_, &common_);
    return numeric_ && common_.status == KLU_OK;
  }

  void solve(double* b) { klu_solve(symbolic_, numeric_, n_, 1, b, &common_); }

  void forget_pivots() { klu_free_numeric(&numeric_, &common_); }

  int patience() const { return sparse_patience; }

 private:
  /// A pivot order gone bad shows as a tiny estimate of the reciprocal condition, as klu_rcond
  /// makes it from the pivots, against the bound that SUNDIALS uses.
  bool pivots_are_good() const {
    static const double trusted = std::pow(std::numeric_limits<double>::epsilon(), 2.0 / 3.0);
    const auto pivots =
        Eigen::Map<const Eigen::ArrayXd>(static_cast<const double*>(numeric_->Udiag), n_).abs();
    return pivots.minCoeff() > trusted * pivots.maxCoeff();
  }

  int n_;
  std::vector<int> start_, row_;
  klu_common common_{};
  klu_symbolic* symbolic_ = nullptr;
  klu_numeric* numeric_ = nullptr;
};

}  // namespace

extern const Backend klu_backend;
const Backend klu_backend{"klu", false, &make_newton_part<Klu>, [] {
                            return std::to_string(KLU_MAIN_VERSION) + "." +
                                   std::to_string(KLU_SUB_VERSION) + "." +
                                   std::to_string(KLU_SUBSUB_VERSION);
                          }};

}  // namespace desmo
