#include "formulations/codegen/order/matcher.h"

#include <algorithm>
#include <cmath>

#include "formulations/codegen/record/inputs.h"
#include "formulations/groupwise/dense_lu.h"

namespace desmo::generate {

Matcher::Matcher(std::vector<Expr> equations, std::vector<Expr> unknowns, const Facts& facts)
    : equations_(std::move(equations)), unknowns_(std::move(unknowns)), facts_(facts) {
  for (const Expr e : equations_) {
    std::map<int, std::vector<double>> slopes;
    for (const Expr input : moving_inputs(e)) {
      const auto at = std::ranges::find(unknowns_, input.id(), &Expr::id);
      if (at != unknowns_.end())
        slopes.emplace(static_cast<int>(at - unknowns_.begin()), partial(e, input).samples());
    }
    slopes_.push_back(std::move(slopes));
  }
}

std::vector<int> Matcher::read_by(int equation) const {
  std::vector<int> result;
  for (const auto& [unknown, slope] : slopes_[equation]) result.push_back(unknown);
  return result;
}

const Match& Matcher::match(const std::vector<int>& unknowns, const std::vector<int>& equations) {
  const auto [it, is_new] = matches_.try_emplace({unknowns, equations});
  Match& match = it->second;
  if (!is_new) return match;
  match.quality = quality(unknowns, equations);
  if (!(match.quality > 0)) return match;
  Task task{{}, {}, facts_};
  for (const int i : unknowns) task.x.push_back(unknowns_[i]);
  for (const int e : equations) task.equations.push_back(equations_[e]);
  match.form = solve_closed(task);
  return match;
}

double Matcher::quality(const std::vector<int>& unknowns, const std::vector<int>& equations) const {
  const std::size_t samples = slopes_[equations[0]].begin()->second.size(), n = unknowns.size();
  double worst = 1;
  for (std::size_t s = 0; s < samples; ++s) {
    std::vector<double> matrix(n * n, 0);
    for (std::size_t r = 0; r < n; ++r) {
      double norm2 = 0;
      for (const auto& [i, slope] : slopes_[equations[r]]) {
        norm2 += slope[s] * slope[s];
        const auto at = std::ranges::find(unknowns, i);
        if (at != unknowns.end()) matrix[r * n + (at - unknowns.begin())] = slope[s];
      }
      for (std::size_t c = 0; c < n; ++c) matrix[r * n + c] /= std::sqrt(norm2);
    }
    const double size = std::exp(DenseLu<double>(std::move(matrix), n).determinant().log);
    worst = std::isnan(size) ? 0 : std::min(worst, size);
  }
  return worst;
}

}  // namespace desmo::generate
