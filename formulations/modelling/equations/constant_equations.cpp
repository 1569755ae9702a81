#include <algorithm>
#include <array>
#include <cmath>

#include "cases/numbers/interval.h"
#include "formulations/constraints/constraints.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

bool holds_to_rounding(const Model& m, const Constraint& c, double reach) {
  bool result = true;
  const auto rounded = [](double value, double magnitude) {
    return Interval(value, max_rounding * magnitude);
  };
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    if constexpr (!has_table<Kind>) {
      std::array<std::array<Interval, max_components>, Kind::operand_sizes.size()> components;
      std::array<const Interval*, Kind::operand_sizes.size()> x;
      for (std::size_t k = 0; k < x.size(); ++k) {
        const Entity& e = m.entities[c.operands[k]];
        for (int i = 0; i < e.size; ++i)
          components[k][i] =
              rounded(m.fixed_values[e.first + i], e.kind == EntityKind::vector ? 1 : reach);
        x[k] = components[k].data();
      }
      std::array<Interval, Kind::constants + 1> constants;
      for (int k = 0; k < Kind::constants; ++k)
        constants[k] = rounded(c.constants[k].value, std::abs(c.constants[k].value));
      std::array<Interval, Kind::rows> phi;
      Kind::residual(x.data(), constants.data(), phi.data());
      result =
          std::ranges::none_of(phi, [](const Interval& y) { return std::abs(y.mid) > y.radius; });
    }
  });
  return result;
}

}  // namespace desmo
