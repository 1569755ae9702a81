#include <algorithm>
#include <map>

#include "formulations/base/per_level.h"
#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/emit/explicit_plan.h"

namespace desmo::generate {

namespace {

using Vector = std::vector<Expr>;

/// Halves rows whose entries all have the constant factor 2. Returns the multiplier of each row.
Vector take_factors(SparseRows& matrix) {
  Vector scales;
  for (std::map<int, Expr>& row : matrix) {
    const bool is_double =
        std::ranges::all_of(row, [](const auto& entry) { return entry.second.factor() == 2; });
    scales.push_back(is_double ? 0.5 : 1);
    for (auto& [column, entry] : row) entry = scales.back() * entry;
  }
  return scales;
}

Vector scaled(Vector rows, const Vector& scales) {
  for (std::size_t r = 0; r < rows.size(); ++r) rows[r] = scales[r] * rows[r];
  return rows;
}

/// The linear system of a core, recorded once. A core of two unknowns is solved by its adjugate,
/// whose latency is short; any other by elimination.
class CoreSystem {
 public:
  explicit CoreSystem(SparseRows m) {
    if (m.size() == 2)
      adjugate_.emplace(std::vector<Vector>{{m[0][0], m[0][1]}, {m[1][0], m[1][1]}});
    else
      elimination_.emplace(std::move(m));
  }

  Vector solve(const Vector& b) const {
    return adjugate_ ? adjugate_->solve(b) : elimination_->solve(b);
  }

  /// Returns the conditions under which a solution is trusted.
  Monitors monitors() const {
    if (adjugate_) return {{{abs(adjugate_->determinant()), 1e-6, adjugate_->magnitude()}}, {}};
    return {{}, elimination_->monitors()};
  }

 private:
  std::optional<Adjugate> adjugate_;
  std::optional<Elimination> elimination_;
};

/// Differentiates sections one after the other, in solution order. Symbols as in differentiate().
class Differentiator {
 public:
  explicit Differentiator(const RecordedPart& part) : part_(part) {
    for (std::size_t i = 0; i < part.q.size(); ++i) {
      known_.set(Level::velocity, part.q[i], part.qd[i]);
      known_.set(Level::acceleration, part.q[i], part.qdd[i]);
    }
  }

  /// Sets the rates of unknowns to zero until differentiate() finds them.
  void forget(const std::vector<int>& unknowns) {
    for (const int i : unknowns)
      for (const Level level : rate_levels) known_.set(level, part_.q[i], 0);
  }

  SectionMotion differentiate(const OrderSection& s) {
    const std::size_t torn = s.torn.size();
    SectionMotion motion;
    // slopes[k]: column k of dx/dτ, for torn unknown k. matrix: dR/dτ.
    std::vector<Vector> slopes;
    SparseRows matrix(torn);
    for (std::size_t k = 0; k < torn; ++k) {
      Rates along;
      along.set(Level::velocity, part_.q[s.torn[k]], 1);
      slopes.push_back(rates_of_definitions(s, along, Level::velocity));
      for (std::size_t r = 0; r < torn; ++r)
        if (const Expr slope = along.of(Level::velocity, s.residuals[r]); !slope.is_zero())
          matrix[r].emplace(static_cast<int>(k), slope);
    }
    // Equations of lengths have the factor 2. Without these multiplications the solution is known
    // earlier.
    const Vector scales = take_factors(matrix);
    const CoreSystem core(matrix);
    motion.increments = core.solve(scaled(s.residuals, scales));
    motion.monitors = core.monitors();

    const std::vector<int> unknowns = unknowns_of(s);
    // Returns the unknowns' rates. named: inputs that stand for them where others read them.
    const auto solve = [&](Level level, const Vector& named) {
      Rates rates = known_;
      const Vector held = rates_of_definitions(s, rates, level);
      Vector right;
      for (const Expr r : s.residuals) right.push_back(-rates.of(level, r));
      Vector result = core.solve(scaled(right, scales));
      for (std::size_t i = 0; i < held.size(); ++i) {
        Expr sum = held[i];
        for (std::size_t k = 0; k < torn; ++k) sum = sum + slopes[k][i] * named[s.torn[k]];
        result.push_back(sum);
      }
      for (const int i : unknowns) known_.set(level, part_.q[i], named[i]);
      return result;
    };
    motion.velocities = solve(Level::velocity, part_.qd);
    motion.accelerations = solve(Level::acceleration, part_.qdd);
    return motion;
  }

 private:
  /// Returns the rates of the defined unknowns, one definition after the other. Sets them in
  /// `rates`, where later definitions read them.
  Vector rates_of_definitions(const OrderSection& s, Rates& rates, Level level) const {
    Vector all;
    for (const Definition& d : s.definitions) {
      const Vector x = d.form.rates(rates, level);
      for (std::size_t i = 0; i < x.size(); ++i) rates.set(level, part_.q[d.unknowns[i]], x[i]);
      append(all, x);
    }
    return all;
  }

  const RecordedPart& part_;
  Rates known_;
};

}  // namespace

std::vector<int> unknowns_of(const OrderSection& s) {
  std::vector<int> result = s.torn;
  for (const Definition& d : s.definitions)
    result.insert(result.end(), d.unknowns.begin(), d.unknowns.end());
  return result;
}

std::vector<SectionMotion> differentiate(const RecordedPart& part,
                                         const std::vector<OrderSection>& order) {
  Differentiator differentiator(part);
  for (const OrderSection& s : order) differentiator.forget(unknowns_of(s));
  std::vector<SectionMotion> result;
  for (const OrderSection& s : order) result.push_back(differentiator.differentiate(s));
  return result;
}

}  // namespace desmo::generate
