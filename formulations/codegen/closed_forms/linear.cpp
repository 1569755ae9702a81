#include <stdexcept>

#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/expansion.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

/// Returns a monitor that refuses the division where the equation hardly depends on x. It compares
/// the derivative by x, the pivot, with the sum of the other derivatives' absolute values.
SizeMonitor pivot_size(Expr equation, Expr x, Expr pivot) {
  Expr others = 0;
  for (const Expr input : moving_inputs(equation))
    if (input.id() != x.id()) others = others + abs(partial(equation, input));
  return {abs(pivot), 1e-6, others};
}

}  // namespace

/// Solves equations that are linear in their unknowns: one by a division, several by elimination.
std::optional<ClosedForm> solve_linear(const Task& task) {
  const std::size_t n = task.x.size();
  std::vector<std::map<int, Expr>> matrix(n);
  std::map<int, Expr> origin;
  for (const Expr x : task.x) origin.emplace(x.id(), Expr(0));
  std::vector<Expr> right;
  for (std::size_t r = 0; r < n; ++r) {
    const std::optional<Quadratic> q = expand(task.equations[r], task.x);
    if (!q || !q->products.empty()) return std::nullopt;
    for (std::size_t i = 0; i < n; ++i)
      if (const Expr c = q->rest.coefficient[i]; !c.is_zero())
        matrix[r].emplace(static_cast<int>(i), c);
    right.push_back(-substitute(task.equations[r], origin));
  }

  ClosedForm form;
  form.rule = "linear";
  if (n == 1) {
    if (matrix[0].empty()) return std::nullopt;
    const Expr pivot = matrix[0].at(0), reciprocal = Expr(1) / pivot;
    form.values = {right[0] * reciprocal};
    form.cost = pivot.moves() ? 2 : 0;
    if (pivot.moves())
      form.monitors.sizes.push_back(pivot_size(task.equations[0], task.x[0], pivot));
    rates_by_equations(form, task.equations, [reciprocal](const std::vector<Expr>& b) {
      return std::vector<Expr>{b[0] * reciprocal};
    });
    return form;
  }
  try {
    const Elimination elimination(matrix);
    form.values = elimination.solve(right);
    form.monitors.pivots = elimination.monitors();
    form.cost = 3 * static_cast<int>(form.monitors.pivots.size());
    rates_by_equations(form, task.equations,
                       [elimination](const std::vector<Expr>& b) { return elimination.solve(b); });
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // the matrix is structurally singular
  }
  return form;
}

}  // namespace desmo::generate
