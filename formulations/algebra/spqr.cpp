// Sparse QR by SuiteSparse's SPQR (GPL): Φ_φ E = Q R with Householder reflections, rank-revealing
// and stable for any conditioning. Ordering and symbolic analysis are done once; every
// factorisation and every solution allocates.

#include <SuiteSparseQR.hpp>
#include <algorithm>
#include <limits>
#include <stdexcept>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

namespace {

class Spqr final : public LinearSolver {
 public:
  explicit Spqr(const Pattern& pattern)
      : n_(pattern.n),
        start_(pattern.column_start.begin(), pattern.column_start.end()),
        row_(pattern.row.begin(), pattern.row.end()) {
    cholmod_l_start(&common_);
    common_.print = 0;
    a_.nrow = a_.ncol = static_cast<std::size_t>(n_);
    a_.nzmax = row_.size();
    a_.p = start_.data();
    a_.i = row_.data();
    a_.itype = CHOLMOD_LONG;
    a_.xtype = CHOLMOD_REAL;
    a_.dtype = CHOLMOD_DOUBLE;
    a_.sorted = a_.packed = 1;
    const bool reveal_rank = true;
    std::vector<double> values(row_.size(), 1.0);  // the symbolic analysis does not read them
    a_.x = values.data();
    qr_ = SuiteSparseQR_symbolic<double>(SPQR_ORDERING_DEFAULT, reveal_rank, &a_, &common_);
    if (!qr_) throw std::invalid_argument("SPQR: the Jacobian could not be analysed");
  }
  ~Spqr() override {
    SuiteSparseQR_free<double>(&qr_, &common_);
    cholmod_l_finish(&common_);
  }

  bool factor(const double* values) override {
    a_.x = const_cast<double*>(values);  // SPQR reads them only
    return SuiteSparseQR_numeric<double>(SPQR_DEFAULT_TOL, &a_, qr_, &common_) && qr_->rank == n_;
  }

  void solve(double* b) override {
    cholmod_dense right{};
    right.nrow = right.nzmax = right.d = static_cast<std::size_t>(n_);
    right.ncol = 1;
    right.x = b;
    right.xtype = CHOLMOD_REAL;
    right.dtype = CHOLMOD_DOUBLE;
    cholmod_dense* y = SuiteSparseQR_qmult<double>(SPQR_QTX, qr_, &right, &common_);
    cholmod_dense* x =
        y ? SuiteSparseQR_solve<double>(SPQR_RETX_EQUALS_B, qr_, y, &common_) : nullptr;
    if (x)
      std::copy_n(static_cast<const double*>(x->x), n_, b);
    else  // out of memory
      std::fill_n(b, n_, std::numeric_limits<double>::quiet_NaN());
    cholmod_l_free_dense(&y, &common_);
    cholmod_l_free_dense(&x, &common_);
  }

 private:
  int n_;
  std::vector<SuiteSparse_long> start_, row_;
  cholmod_common common_{};
  cholmod_sparse a_{};
  SuiteSparseQR_factorization<double>* qr_ = nullptr;
};

}  // namespace

extern const Backend spqr_backend{
    .name = "spqr",
    .make_solver = &make_solver<Spqr>,
    .version =
        [] { return version_text(SPQR_MAIN_VERSION, SPQR_SUB_VERSION, SPQR_SUBSUB_VERSION); },
    .allocates = true,
    .slow_reason = "orthogonal factorisation serves accuracy, not speed"};

}  // namespace desmo
