#include "formulations/codegen/order/tearing.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <tuple>

#include "formulations/codegen/record/expression.h"
#include "formulations/motion/groupwise/dense_lu.h"

namespace desmo::generate {

namespace {

/// Smallest quality (≥) of a closed form, unless it solves a whole block. With less quality it is
/// singular not far from where it was sampled.
constexpr double min_quality = 0.03;
/// Quality above which closed forms count as equally good.
constexpr double good_quality = 0.25;

constexpr std::size_t max_set = 4;  // number of equations that are solved together (≤)
/// Limits of an exhaustive search (≤): number of torn unknowns, and of sets of them.
constexpr std::size_t max_torn = 3, max_combinations = 3000;

/// Returns the numbers below n that are in a set.
std::vector<int> numbers_in(const auto& set, std::size_t n) {
  std::vector<int> result;
  for (std::size_t i = 0; i < n; ++i)
    if (set[i]) result.push_back(static_cast<int>(i));
  return result;
}

/// Returns a rank of orders: the smaller, the better.
auto rank(const TornOrder& t) {
  return std::tuple(t.unplaced, -std::min(t.quality, good_quality), t.cost, -t.quality);
}

}  // namespace

Tearing::Tearing(std::vector<Expr> equations, std::vector<Expr> unknowns, const Facts& facts)
    : equations_(std::move(equations)),
      unknowns_(std::move(unknowns)),
      facts_(facts),
      slopes_(equations_.size()),
      reads_(equations_.size()) {
  if (unknowns_.size() > max_unknowns)
    throw std::invalid_argument("too many unknowns in one irreducible block to be torn");
  for (std::size_t e = 0; e < equations_.size(); ++e)
    for (const Expr input : moving_inputs(equations_[e])) {
      const auto at = std::ranges::find(unknowns_, input.id(), &Expr::id);
      if (at == unknowns_.end()) continue;
      const int unknown = static_cast<int>(at - unknowns_.begin());
      slopes_[e].emplace(unknown, partial(equations_[e], input).samples());
      reads_[e].set(unknown);
    }
}

/// Returns the outcome of solving equations for as many unknowns. Both lists are ascending.
const Tearing::Match& Tearing::match(const std::vector<int>& unknowns,
                                     const std::vector<int>& equations) {
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

double Tearing::quality(const std::vector<int>& unknowns, const std::vector<int>& equations) const {
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

/// Adds equations to a set, ascending, until it has `size` of them, for as many unknowns. Places
/// their closed form if there is a good one, else goes on searching. Returns whether it placed one.
bool Tearing::extend(Walk& w, TornOrder& order, std::vector<int>& equations, const Set& unknowns,
                     std::size_t size) {
  if (equations.size() == size) {
    if (unknowns.count() != size) return false;
    const std::vector<int> found = numbers_in(unknowns, unknowns_.size());
    const Match& m = match(found, equations);
    if (!m.form || m.quality < min_quality) return false;
    order.placed.push_back({*m.form, found, equations});
    order.quality = std::min(order.quality, m.quality);
    order.cost += m.form->cost;
    w.open &= ~unknowns;
    for (const int e : equations) w.used[e] = true;
    for (Set& reads : w.reads) reads &= w.open;
    return true;
  }
  const int first = equations.empty() ? 0 : equations.back() + 1;
  for (int e = first; e < static_cast<int>(reads_.size()); ++e) {
    if (w.used[e] || w.reads[e].none()) continue;
    const Set all = unknowns | w.reads[e];
    if (all.count() > size) continue;
    equations.push_back(e);
    if (extend(w, order, equations, all, size)) return true;
    equations.pop_back();
  }
  return false;
}

bool Tearing::place_next(Walk& w, TornOrder& order) {
  for (std::size_t size = 1; size <= max_set; ++size) {
    std::vector<int> equations;
    if (extend(w, order, equations, {}, size)) return true;
  }
  return false;
}

TornOrder Tearing::walk(const std::vector<int>& torn) {
  Walk w{{}, std::vector<bool>(reads_.size(), false), reads_};
  for (std::size_t i = 0; i < unknowns_.size(); ++i) w.open.set(i);
  for (const int t : torn) w.open.reset(t);
  for (Set& reads : w.reads) reads &= w.open;
  TornOrder order;
  order.torn = torn;
  while (w.open.any() && place_next(w, order)) {
  }
  order.unplaced = static_cast<int>(w.open.count());
  w.used.flip();
  order.left_over = numbers_in(w.used, w.used.size());
  return order;
}

std::optional<TornOrder> Tearing::best_of_size(std::size_t size) {
  std::vector<bool> torn(unknowns_.size());
  std::fill_n(torn.begin(), size, true);
  std::optional<TornOrder> best;
  do {
    TornOrder order = walk(numbers_in(torn, torn.size()));
    if (order.unplaced == 0 && (!best || rank(order) < rank(*best))) best = std::move(order);
  } while (std::prev_permutation(torn.begin(), torn.end()));  // takes the next set of torn unknowns
  return best;
}

TornOrder Tearing::greedy() {
  TornOrder order = walk({});
  while (order.unplaced > 0) {
    std::optional<TornOrder> best;
    for (int i = 0; i < static_cast<int>(unknowns_.size()); ++i) {
      const bool placed = std::ranges::any_of(order.placed, [&](const PlacedForm& p) {
        return std::ranges::find(p.unknowns, i) != p.unknowns.end();
      });
      if (placed || std::ranges::find(order.torn, i) != order.torn.end()) continue;
      std::vector<int> torn = order.torn;
      torn.push_back(i);
      TornOrder candidate = walk(torn);
      if (!best || rank(candidate) < rank(*best)) best = std::move(candidate);
    }
    order = std::move(*best);
  }
  // Removes torn unknowns that later ones made superfluous.
  for (std::size_t k = 0; k < order.torn.size();) {
    std::vector<int> torn = order.torn;
    torn.erase(torn.begin() + static_cast<std::ptrdiff_t>(k));
    TornOrder fewer = walk(torn);
    if (fewer.unplaced == 0)
      order = std::move(fewer);
    else
      ++k;
  }
  return order;
}

TornOrder Tearing::best() {
  TornOrder order = walk({});
  if (order.unplaced == 0) return order;
  std::vector<int> all(unknowns_.size());
  std::iota(all.begin(), all.end(), 0);
  if (all.size() <= max_set)
    if (const Match& m = match(all, all); m.form)
      return {{}, {{*m.form, all, all}}, {}, 0, m.quality, m.form->cost};
  std::size_t combinations = 1;
  for (std::size_t size = 1; size <= max_torn && size < all.size(); ++size) {
    combinations = combinations * (all.size() - size + 1) / size;
    if (combinations > max_combinations) break;
    if (std::optional<TornOrder> found = best_of_size(size)) return *found;
  }
  return greedy();
}

}  // namespace desmo::generate
