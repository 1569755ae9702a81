#include "formulations/modelling/equations/constant_equations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "cases/mechanism/names.h"
#include "cases/numbers/interval.h"
#include "formulations/constraints/constraints.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

void require_holds(const Model& m, const Constraint& c, double reach) {
  const auto is_fixed = [&](EntityId e) { return m.entities[e].fixed; };
  if (!std::ranges::all_of(c.operands, is_fixed)) return;
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
      if (std::ranges::any_of(phi, [](const Interval& y) { return std::abs(y.mid) > y.radius; }))
        throw std::invalid_argument(
            in_quotes(c.name) +
            " does not hold: the places on the ground and the shape of the body, or two shapes, "
            "contradict each other; make them the same, to the last digit");
    }
  });
}

}  // namespace desmo
