// Sparse LDLᵀ by HSL's MA27 (Duff & Reid 1983), the paper's solver, in a library that the user
// brings. Analysis is done once; the memory of the factors is reused.
//
// MA27 takes symmetric matrices; Φ_φ is not symmetric, and the paper does not say how it was
// treated. Here MA27 solves normal equations, Φ_φᵀ Φ_φ or Φ_φ Φ_φᵀ, whichever takes fewer
// operations, like CHOLMOD. The augmented matrix [I Φ_φᵀ; Φ_φ 0] has twice the unknowns.
// Eliminating its unit diagonal leaves −Φ_φ Φ_φᵀ, so its errors grow with the square of the
// condition number as well. [0 Φ_φᵀ; Φ_φ 0] avoids that, but has no diagonal, which the analysis
// relies on. Its pivots come later than predicted, in pairs, and take more memory. Pivots of normal
// equations are positive, and stay where the analysis puts them.

#include <algorithm>
#include <array>
#include <limits>
#include <stdexcept>
#include <utility>
#include <vector>

#include "formulations/algebra/backend.h"
#include "formulations/algebra/coinhsl.h"
#include "formulations/algebra/normal_equations.h"
#include "formulations/equations/pattern.h"

namespace desmo {

namespace {

/// Control and information arrays of MA27, named as in its specification, whose elements count from
/// 1.
struct Ma27Dialogue {
  std::array<int, 30> icntl;
  std::array<double, 5> cntl;
  std::array<int, 20> info{};

  /// Sets defaults for definite matrices: no search for pivots, no printing.
  Ma27Dialogue() {
    coinhsl().ma27.set_defaults(icntl.data(), cntl.data());
    icntl[0] = icntl[1] = 0;
    cntl[0] = 0;
  }

  /// Sets the smallest magnitude that is accepted as a pivot.
  void set_least_pivot(double size) { cntl[2] = size; }

  bool succeeded() const { return info[0] == 0; }
  bool lacks_integers() const { return info[0] == -3; }
  bool lacks_reals() const { return info[0] == -4; }
  /// Returns a size that may suffice for the memory that was too small.
  int may_suffice() const { return info[1]; }
  /// Return the numbers of reals and integers that the factors take without compression. They are
  /// exact for a definite matrix.
  int reals() const { return info[2]; }
  int integers() const { return info[3]; }
};

/// Enlarges memory to the suggested size, and at least by half, so that repetition ends. Returns
/// false when the size would exceed an int.
template <class Number>
bool grow(std::vector<Number>& memory, int may_suffice) {
  const std::size_t wanted = std::max(may_suffice, 0), more = memory.size() + memory.size() / 2 + 1;
  if (std::max(wanted, more) > std::size_t{std::numeric_limits<int>::max()}) return false;
  memory.resize(std::max(wanted, more));
  return true;
}

template <class Number>
int count(const std::vector<Number>& numbers) {
  return static_cast<int>(numbers.size());
}

/// Normal equations and MA27's order of elimination for them.
struct Ma27Analysis {
  NormalEquations normal;
  std::vector<int> row, column;  ///< row and column of each entry, counted from 1
  std::vector<int> order;        ///< MA27's IKEEP, the order of pivots
  std::vector<int> work;         ///< MA27's IW1, workspace of all calls
  int steps = 0;
  double operations = 0;
  Ma27Dialogue dialogue;

  /// Throws std::invalid_argument when MA27 cannot analyse them.
  Ma27Analysis(const Pattern& pattern, NormalForm form)
      : normal(pattern, form), order(3 * pattern.n), work(2 * pattern.n) {
    const int n = normal.n();
    for (int j = 0; j < n; ++j)
      for (int e = normal.column_start()[j]; e < normal.column_start()[j + 1]; ++e) {
        row.push_back(normal.row()[e] + 1);
        column.push_back(j + 1);
      }
    const int entries = count(row);
    std::vector<int> space(2 * (2 * row.size() + order.size()) + 1);  // twice the minimum
    Ma27Dialogue& d = dialogue;
    do {
      const int size = count(space);
      int order_of_its_own = 0;
      coinhsl().ma27.analyse(&n, &entries, row.data(), column.data(), space.data(), &size,
                             order.data(), work.data(), &steps, &order_of_its_own, d.icntl.data(),
                             d.cntl.data(), d.info.data(), &operations);
    } while (d.lacks_integers() && grow(space, d.may_suffice()));
    if (!d.succeeded()) throw std::invalid_argument("MA27: the Jacobian could not be analysed");
  }
};

/// Returns the analysis of the form that takes fewer operations.
Ma27Analysis cheapest_ma27_analysis(const Pattern& pattern) {
  Ma27Analysis columns(pattern, NormalForm::columns), rows(pattern, NormalForm::rows);
  return rows.operations < columns.operations ? std::move(rows) : std::move(columns);
}

class Ma27 final : public LinearSolver {
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
    // The matrix is positive semidefinite, so its largest entry is on the diagonal. A pivot below
    // that entry's rounding counts as zero.
    a_.dialogue.set_least_pivot(std::numeric_limits<double>::epsilon() *
                                std::ranges::max(a_.normal.values()));
    do factor_once();
    while (enlarge_memory());
    return a_.dialogue.succeeded();
  }

  void solve(double* b) override {
    a_.normal.form_right_side(values_, b, right_.data());
    const int reals = count(reals_), integers = count(integers_);
    coinhsl().ma27.solve(&n_, reals_.data(), &reals, integers_.data(), &integers, front_.data(),
                         &max_front_, right_.data(), a_.work.data(), &a_.steps,
                         a_.dialogue.icntl.data(), a_.dialogue.info.data());
    a_.normal.recover_solution(values_, right_.data(), b);
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

  /// Enlarges memory that was short. Returns whether it did.
  bool enlarge_memory() {
    const Ma27Dialogue& d = a_.dialogue;
    return (d.lacks_reals() && grow(reals_, d.may_suffice())) ||
           (d.lacks_integers() && grow(integers_, d.may_suffice()));
  }

  Ma27Analysis a_;
  int n_, entries_;
  std::vector<double> reals_;  // the matrix; then, with integers_, its factors
  std::vector<int> integers_;
  std::vector<double> front_;  // MA27's W, workspace: no front is larger than the matrix
  int max_front_ = 0;
  std::vector<double> right_;       // right-hand side, then solution
  const double* values_ = nullptr;  // values of Φ_φ that were factorised last
};

}  // namespace

extern const Backend ma27_backend{.name = "ma27",
                                  .make_solver = &make_solver<Ma27>,
                                  .version = [] { return coinhsl().version; },
                                  .absence = [] { return coinhsl().absence; }};

}  // namespace desmo
