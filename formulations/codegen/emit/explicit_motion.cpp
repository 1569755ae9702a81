#include "formulations/codegen/emit/explicit_motion.h"

#include <algorithm>
#include <map>

#include "formulations/codegen/order/core_system.h"

namespace desmo::generate {

namespace {

using Vector = std::vector<Expr>;

/// Where all entries of a row are twice something, halves them; what rows were multiplied by.
Vector take_factors(std::vector<std::map<int, Expr>>& matrix) {
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

class Differentiator {
 public:
  explicit Differentiator(const RecordedPart& part) : part_(part) {
    for (std::size_t i = 0; i < part.q.size(); ++i) {
      known_.set_first(part.q[i], part.qd[i]);
      known_.set_second(part.q[i], part.qdd[i]);
    }
  }

  /// Rates of the unknowns are zero until they are found.
  void forget(const std::vector<int>& unknowns) {
    for (const int i : unknowns) {
      known_.set_first(part_.q[i], 0);
      known_.set_second(part_.q[i], 0);
    }
  }

  SectionMotion differentiate(const OrderSection& s) {
    const std::size_t torn = s.torn.size();
    SectionMotion motion;
    // dx/dτ, a column for each torn unknown, and the core's matrix.
    std::vector<Vector> slopes;
    std::vector<std::map<int, Expr>> matrix(torn);
    for (std::size_t k = 0; k < torn; ++k) {
      Rates along;
      along.set_first(part_.q[s.torn[k]], 1);
      slopes.push_back(first(s, along));
      for (std::size_t r = 0; r < torn; ++r)
        if (const Expr slope = along.first(s.residuals[r]); !slope.is_zero())
          matrix[r].emplace(static_cast<int>(k), slope);
    }
    // Lengths have rows of twice something: what waits for them does not wait for the doubling.
    const Vector scales = take_factors(matrix);
    const CoreSystem core(matrix);
    motion.increments = core.solve(scaled(s.residuals, scales));
    motion.pivots = core.pivots();
    motion.sizes = core.sizes();

    const std::vector<int> unknowns = unknowns_of(s);
    const auto complete = [&](const Vector& held, Vector residual_rates, const Vector& named) {
      for (Expr& r : residual_rates) r = -r;
      Vector rates = core.solve(scaled(residual_rates, scales));
      for (std::size_t i = 0; i < held.size(); ++i) {
        Expr sum = held[i];
        for (std::size_t k = 0; k < torn; ++k) sum = sum + slopes[k][i] * named[s.torn[k]];
        rates.push_back(sum);
      }
      return rates;
    };
    Rates velocities = known_;
    const Vector v = first(s, velocities);
    motion.velocities = complete(v, all(s.residuals, velocities, &Rates::first), part_.qd);
    for (const int i : unknowns) known_.set_first(part_.q[i], part_.qd[i]);
    Rates accelerations = known_;
    const Vector a = second(s, accelerations);
    motion.accelerations = complete(a, all(s.residuals, accelerations, &Rates::second), part_.qdd);
    for (const int i : unknowns) known_.set_second(part_.q[i], part_.qdd[i]);
    return motion;
  }

 private:
  static Vector all(const Vector& expressions, const Rates& rates,
                    Expr (Rates::*level)(Expr) const) {
    Vector result;
    for (const Expr e : expressions) result.push_back((rates.*level)(e));
    return result;
  }

  /// Rates of what is defined, one definition after the other; `rates` takes them up.
  Vector first(const OrderSection& s, Rates& rates) const {
    Vector all;
    for (const Definition& d : s.definitions) {
      const Vector x = d.form.first(rates);
      for (std::size_t i = 0; i < x.size(); ++i) rates.set_first(part_.q[d.unknowns[i]], x[i]);
      all.insert(all.end(), x.begin(), x.end());
    }
    return all;
  }
  Vector second(const OrderSection& s, Rates& rates) const {
    Vector all;
    for (const Definition& d : s.definitions) {
      const Vector x = d.form.second(rates);
      for (std::size_t i = 0; i < x.size(); ++i) rates.set_second(part_.q[d.unknowns[i]], x[i]);
      all.insert(all.end(), x.begin(), x.end());
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
