// Sparse LDLᵀ by HSL's MA27 (Duff & Reid 1983), the paper's solver, in a library that the user
// brings. Analysis once; the memory of the factors is reused.
//
// MA27 takes symmetric matrices; Φ_φ is not symmetric, and the paper does not say how it was
// treated. Here MA27 solves normal equations, Φ_φᵀ Φ_φ or Φ_φ Φ_φᵀ, whichever takes fewer
// operations, like CHOLMOD. The augmented matrix [I Φ_φᵀ; Φ_φ 0] has twice the unknowns.
// Eliminating its unit diagonal leaves −Φ_φ Φ_φᵀ, so its errors grow with the square of the
// condition number as well. [0 Φ_φᵀ; Φ_φ 0] avoids that, but has no diagonal, which the analysis
// relies on. Its pivots come later than predicted, in pairs, and take more memory. Pivots of normal
// equations are positive, and stay where the analysis puts them.

#include <algorithm>
#include <limits>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/coinhsl.h"
#include "formulations/algebra/ma27_analysis.h"

namespace desmo {

namespace {

class Ma27 final : public LinearSolver<double> {
 public:
  explicit Ma27(const Pattern& pattern)
      : a_(cheapest_ma27_analysis(pattern)),
        n_(pattern.n),
        entries_(count(a_.row)),
        reals_(std::max(a_.dialogue.reals(), entries_)),
        integers_(std::max(a_.dialogue.integers(), 1)),
        front_(n_),
        right_(n_) {}

  bool factor(const double* values) override {
    values_ = values;
    a_.normal.refill(values);
    // The largest entry is on the diagonal. What is as small as its rounding is no pivot.
    a_.dialogue.set_least_pivot(std::numeric_limits<double>::epsilon() *
                                std::ranges::max(a_.normal.values()));
    do factor_once();
    while (has_grown());
    return a_.dialogue.succeeded();
  }

  void solve(double* b) override {
    a_.normal.right_side(values_, b, right_.data());
    const int reals = count(reals_), integers = count(integers_);
    coinhsl().ma27.solve(&n_, reals_.data(), &reals, integers_.data(), &integers, front_.data(),
                         &max_front_, right_.data(), a_.work.data(), &a_.steps,
                         a_.dialogue.icntl.data(), a_.dialogue.info.data());
    a_.normal.solution(values_, right_.data(), b);
  }

 private:
  void factor_once() {
    std::ranges::copy(a_.normal.values(), reals_.begin());
    const int reals = count(reals_), integers = count(integers_);
    Ma27Dialogue& d = a_.dialogue;
    coinhsl().ma27.factorise(&n_, &entries_, a_.row.data(), a_.column.data(), reals_.data(), &reals,
                             integers_.data(), &integers, a_.order.data(), &a_.steps, &max_front_,
                             a_.work.data(), d.icntl.data(), d.cntl.data(), d.info.data());
  }

  /// Whether memory was short, and there is more of it now.
  bool has_grown() {
    const Ma27Dialogue& d = a_.dialogue;
    return (d.lacks_reals() && grow(reals_, d.may_suffice())) ||
           (d.lacks_integers() && grow(integers_, d.may_suffice()));
  }

  Ma27Analysis a_;
  int n_, entries_;
  std::vector<double> reals_;  // the matrix, then its factors, with what is in integers_
  std::vector<int> integers_;
  std::vector<double> front_;  // no front is larger than the matrix
  int max_front_ = 0;
  std::vector<double> right_;       // right-hand side, then solution
  const double* values_ = nullptr;  // those factorised last
};

}  // namespace

extern const Backend ma27_backend;
const Backend ma27_backend{"ma27",
                           false,
                           &make_sparse_solver<Ma27>,
                           [] { return coinhsl().version; },
                           true,
                           [] { return coinhsl().absence; }};

}  // namespace desmo
