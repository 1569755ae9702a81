#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/expansion.h"

namespace desmo::generate {

namespace {

/// An equation scale (s dᵢ − w) = 0, where s and dᵢ are unknowns. row: its index in the task.
/// direction, length: indices of dᵢ and s.
struct Along {
  int row, direction, length;
  Expr w, scale;
};

/// Returns the index of the unknown that an expression equals; nullopt when it is anything else.
std::optional<int> as_unknown(const Affine& a) {
  std::optional<int> found;
  for (std::size_t i = 0; i < a.coefficient.size(); ++i) {
    if (a.coefficient[i].is_zero()) continue;
    if (found || !Graph::current().is(a.coefficient[i].id(), 1)) return std::nullopt;
    found = static_cast<int>(i);
  }
  return a.constant.is_zero() ? found : std::nullopt;
}

/// Returns an equation whose only product is of two unknowns; nullopt for any other equation. The
/// first unknown is taken for the direction, until agree_on_length() decides.
std::optional<Along> as_along(const Quadratic& q, int row) {
  if (q.products.size() != 1 || !q.rest.is_constant()) return std::nullopt;
  const Quadratic::Product& p = q.products[0];
  const std::optional<int> i = as_unknown(p.a), j = as_unknown(p.b);
  if (!i || !j || *i == *j || !p.scale.is_constant()) return std::nullopt;
  return Along{row, *i, *j, -q.rest.constant / p.scale, p.scale};
}

/// Returns ρ² of the equation Σ dᵢ² = ρ² over the directions dᵢ; nullopt for any other equation.
std::optional<Expr> as_radius2(const Quadratic& q, const std::vector<Along>& along) {
  if (q.products.size() != along.size() || !q.rest.is_constant()) return std::nullopt;
  std::vector<int> seen(q.rest.coefficient.size(), 0);
  for (const Quadratic::Product& p : q.products) {
    const std::optional<int> i = as_unknown(p.a), j = as_unknown(p.b);
    if (!i || i != j || !Graph::current().is(p.scale.id(), 1)) return std::nullopt;
    ++seen[*i];
  }
  for (const Along& a : along)
    if (seen[a.direction] != 1) return std::nullopt;
  return -q.rest.constant;
}

/// Makes the unknown that all products share the length of each. Returns whether there is one.
bool agree_on_length(std::vector<Along>& along) {
  int s = along[0].length;
  for (const Along& a : along)
    if (a.length != s && a.direction != s) s = along[0].direction;
  for (Along& a : along) {
    if (a.direction == s) std::swap(a.direction, a.length);
    if (a.length != s) return false;
  }
  return true;
}

/// The equations w = s d and ‖d‖ = ρ, for a length s and a direction d.
struct DirectionAndLength {
  std::vector<Along> along;
  int unit_row;  ///< index of ‖d‖² = ρ²
  Expr radius2;  ///< ρ²
};

std::optional<DirectionAndLength> recognise(const Task& task) {
  const std::size_t n = task.x.size();
  if (n < 3 || n > 4) return std::nullopt;
  DirectionAndLength found{{}, -1, 0};
  std::optional<Quadratic> unit;
  for (std::size_t r = 0; r < n; ++r) {
    const int row = static_cast<int>(r);
    const std::optional<Quadratic> q = expand(task.equations[r], task.x);
    if (!q) return std::nullopt;
    if (const std::optional<Along> a = as_along(*q, row)) {
      found.along.push_back(*a);
    } else {
      found.unit_row = row;
      unit = q;
    }
  }
  if (found.along.size() != n - 1 || !unit || !agree_on_length(found.along)) return std::nullopt;
  const std::optional<Expr> radius2 = as_radius2(*unit, found.along);
  if (!radius2) return std::nullopt;
  found.radius2 = *radius2;
  return found;
}

}  // namespace

/// Solves w = s d and ‖d‖ = ρ for s and d: a line's length and direction.
std::optional<ClosedForm> solve_direction_and_length(const Task& task) {
  const std::optional<DirectionAndLength> found = recognise(task);
  if (!found) return std::nullopt;
  const auto& [along, unit_row, radius2] = *found;
  const int s = along[0].length;

  Expr w2 = along[0].w * along[0].w, size = 0;
  for (std::size_t k = 1; k < along.size(); ++k) w2 = w2 + along[k].w * along[k].w;
  for (const Along& a : along) size = size + magnitude(a.w) * magnitude(a.w);

  ClosedForm form;
  form.rule = "direction and length";
  const Expr length = task.x[s], branch = branch_of(length);
  form.roots.push_back({branch, length});
  const Expr value = branch * sqrt(w2 / radius2);
  const Expr inverse = value * (radius2 / w2);  // 1/s
  form.values.resize(task.x.size());
  form.values[s] = value;
  for (const Along& a : along) form.values[a.direction] = a.w * inverse;
  form.cost = 4;
  form.monitors.sizes.push_back({w2, 1e-12, size});

  // The differentiated equations, with right-hand sides b, are scale (s ḋᵢ + ṡ dᵢ) = b and
  // 2 d·ḋ = b.
  std::vector<Expr> d;
  for (const Along& a : along) d.push_back(task.x[a.direction]);
  rates_by_equations(form, task.equations, [=, given = *found](const std::vector<Expr>& b) {
    const Expr along_d = b[given.unit_row] * 0.5;  // d·ḋ
    std::vector<Expr> right;
    Expr across = 0;
    for (std::size_t k = 0; k < d.size(); ++k) {
      right.push_back(b[given.along[k].row] / given.along[k].scale);
      across = across + d[k] * right[k];
    }
    std::vector<Expr> x(b.size());
    x[s] = (across - length * along_d) / given.radius2;
    for (std::size_t k = 0; k < d.size(); ++k)
      x[given.along[k].direction] = (right[k] - x[s] * d[k]) * inverse;
    return x;
  });
  return form;
}

}  // namespace desmo::generate
