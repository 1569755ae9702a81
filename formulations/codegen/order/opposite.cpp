#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate {

namespace {

/// The values if its only branch were another.
std::vector<Expr> values_on(const ClosedForm& form, Expr branch) {
  std::vector<Expr> result;
  for (const Expr v : form.values)
    result.push_back(substitute(v, {{form.roots.front().branch.id(), branch}}));
  return result;
}

bool are_equal(const std::vector<Expr>& a, const std::vector<Expr>& b, double sign) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (a[i].id() != (sign * b[i]).id()) return false;
  return a.size() == b.size();
}

bool has_one_root_and_no_angle(const ClosedForm& form) {
  return form.roots.size() == 1 && !form.bearing;
}

}  // namespace

std::optional<ClosedForm> as_earlier_or_opposite(const ClosedForm& form, const ClosedForm& earlier,
                                                 const std::vector<Expr>& x) {
  if (!has_one_root_and_no_angle(form) || !has_one_root_and_no_angle(earlier) ||
      form.values.size() != earlier.values.size())
    return std::nullopt;
  const Expr branch = form.roots.front().branch, its_branch = earlier.roots.front().branch;
  if (!are_equal(values_on(earlier, -its_branch), earlier.values, -1)) return std::nullopt;
  const std::vector<Expr> on_this = values_on(earlier, branch);
  const bool same = are_equal(form.values, on_this, 1);
  if (!same && !are_equal(form.values, on_this, -1)) return std::nullopt;

  const Expr sign = (same ? 1 : -1) * (branch * its_branch);
  const auto signed_all = [sign](std::vector<Expr> values) {
    for (Expr& v : values) v = sign * v;
    return values;
  };
  ClosedForm result;
  result.rule = form.rule + " again";
  result.values = signed_all(x);
  result.roots = form.roots;
  result.rates = [=](const Rates& rates, Level level) {
    std::vector<Expr> of_x;
    for (const Expr e : x) of_x.push_back(rates.of(level, e));
    return signed_all(of_x);
  };
  return result;
}

}  // namespace desmo::generate
