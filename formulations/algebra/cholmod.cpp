// Sparse Cholesky by SuiteSparse's CHOLMOD on the normal equations, Φ_φᵀ Φ_φ or Φ_φ Φ_φᵀ, whichever
// takes fewer operations. They are permuted beforehand, so that CHOLMOD factorises in natural order
// without copies. Ordering and symbolic analysis are done once; the memory of the factor is reused.

#include <cholmod.h>

#include <stdexcept>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/normal_equations.h"

namespace desmo {

namespace {

cholmod_sparse view(NormalEquations& normal) {
  cholmod_sparse a{};
  a.nrow = a.ncol = static_cast<std::size_t>(normal.n());
  a.nzmax = normal.row().size();
  a.p = normal.column_start().data();
  a.i = normal.row().data();
  a.x = normal.values().data();
  a.stype = 1;  // upper triangle
  a.itype = CHOLMOD_INT;
  a.xtype = CHOLMOD_REAL;
  a.dtype = CHOLMOD_DOUBLE;
  a.sorted = a.packed = 1;
  return a;
}

/// A form of the normal equations with an order of its columns. operations: what CHOLMOD counts for
/// the factorisation.
struct Choice {
  NormalForm form;
  std::vector<int> order;
  double operations;
};

/// Returns the fill-reducing order that CHOLMOD itself finds best.
Choice fill_reducing_order(const Pattern& pattern, NormalForm form) {
  NormalEquations normal(pattern, form);
  cholmod_common common;
  cholmod_start(&common);
  cholmod_sparse a = view(normal);
  cholmod_factor* l = cholmod_analyze(&a, &common);
  Choice choice{form, {}, common.fl};
  if (l) choice.order.assign(static_cast<int*>(l->Perm), static_cast<int*>(l->Perm) + pattern.n);
  cholmod_free_factor(&l, &common);
  cholmod_finish(&common);
  if (choice.order.empty())
    throw std::invalid_argument("CHOLMOD: the Jacobian could not be analysed");
  return choice;
}

NormalEquations cheapest_normal_equations(const Pattern& pattern) {
  const Choice columns = fill_reducing_order(pattern, NormalForm::columns);
  const Choice rows = fill_reducing_order(pattern, NormalForm::rows);
  const Choice& best = rows.operations < columns.operations ? rows : columns;
  return NormalEquations(pattern, best.form, best.order);
}

class Cholmod final : public LinearSolver {
 public:
  explicit Cholmod(const Pattern& pattern) : normal_(cheapest_normal_equations(pattern)) {
    cholmod_start(&common_);
    common_.nmethods = 1;
    common_.method[0].ordering = CHOLMOD_NATURAL;
    common_.postorder = false;
    common_.supernodal = CHOLMOD_SIMPLICIAL;  // the columns are too short for BLAS to pay
    common_.print = 0;
    a_ = view(normal_);
    l_ = cholmod_analyze(&a_, &common_);
    right_ = cholmod_allocate_dense(normal_.n(), 1, normal_.n(), CHOLMOD_REAL, &common_);
    if (!l_ || !right_) throw std::invalid_argument("CHOLMOD: the Jacobian could not be analysed");
  }
  ~Cholmod() override {
    cholmod_free_dense(&x_, &common_);
    cholmod_free_dense(&y_, &common_);
    cholmod_free_dense(&e_, &common_);
    cholmod_free_dense(&right_, &common_);
    cholmod_free_factor(&l_, &common_);
    cholmod_finish(&common_);
  }

  bool factor(const double* values) override {
    values_ = values;
    normal_.refill(values);
    return cholmod_factorize(&a_, l_, &common_) && common_.status == CHOLMOD_OK;
  }

  void solve(double* b) override {
    normal_.form_right_side(values_, b, static_cast<double*>(right_->x));
    cholmod_solve2(CHOLMOD_A, l_, right_, nullptr, &x_, nullptr, &y_, &e_, &common_);
    // CHOLMOD cuts y down to one row. Without its shape restored, it would be allocated anew.
    if (y_) y_->d = y_->nrow = y_->nzmax / y_->ncol;
    normal_.recover_solution(values_, static_cast<const double*>(x_->x), b);
  }

 private:
  NormalEquations normal_;
  cholmod_common common_;
  cholmod_sparse a_{};
  cholmod_factor* l_ = nullptr;
  cholmod_dense *right_ = nullptr, *x_ = nullptr, *y_ = nullptr, *e_ = nullptr;
  const double* values_ = nullptr;  // values of Φ_φ that were factorised last
};

}  // namespace

extern const Backend cholmod_backend{
    .name = "cholmod",
    .make_solver = &make_solver<Cholmod>,
    .version =
        [] {
          return version_text(CHOLMOD_MAIN_VERSION, CHOLMOD_SUB_VERSION, CHOLMOD_SUBSUB_VERSION);
        },
};

}  // namespace desmo
