#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/expansion.h"

namespace desmo::generate {

/// Solves a cos θ + b sin θ = 0, which two angles half a turn apart fulfil. The branch is the sign
/// of the left side's derivative by θ.
std::optional<ClosedForm> solve_angle(const Task& task) {
  if (task.x.size() != 1) return std::nullopt;
  const Expr theta = task.x[0];
  const std::optional<Trigonometric> t = expand_angle(task.equations[0], theta);
  if (!t || !t->rest.is_zero() || (t->cosine.is_zero() && t->sine.is_zero())) return std::nullopt;
  const auto& [a, b, rest] = *t;
  const Expr pivot = b * cos(theta) - a * sin(theta), branch = branch_of(pivot);
  const Expr radius2 = a * a + b * b;
  // Both angles have the same rates, so that these need no branch.
  ClosedForm form = angle_by_bearing("angle modulo half a turn", {b, -a}, radius2);
  form.bearing = {branch * b, -(branch * a)};
  const Expr ma = magnitude(a), mb = magnitude(b);
  form.monitors.sizes.push_back({radius2, 1e-12, ma * ma + mb * mb});
  form.roots.push_back({branch, pivot});
  return form;
}

}  // namespace desmo::generate
