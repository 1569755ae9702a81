#include "formulations/scaling/length_powers.h"

#include <array>
#include <cmath>

#include "formulations/scaling/scales.h"

namespace desmo {

namespace {

constexpr int least = -1, most = 2;

/// Between 1 and 2.
double any_number(int index) { return 1 + std::fmod(0.618033988749895 * (index + 1), 1); }

/// Φ where everything is some number, lengths in a unit of which that many make one.
template <class Kind>
std::array<double, Kind::rows> residual(const std::vector<bool>& is_length,
                                        const std::vector<int>& powers, double unit) {
  constexpr std::size_t operands = Kind::operand_sizes.size();
  std::array<std::array<double, 3>, operands> values;
  std::array<const double*, operands> x;
  int index = 0;
  for (std::size_t k = 0; k < operands; ++k) {
    for (int i = 0; i < Kind::operand_sizes[k]; ++i)
      values[k][i] = any_number(index++) * (is_length[k] ? unit : 1);
    x[k] = values[k].data();
  }
  std::array<double, Kind::constants + 1> c{};
  for (int k = 0; k < Kind::constants; ++k) c[k] = any_number(index++) * std::pow(unit, powers[k]);
  std::array<double, Kind::rows> phi;
  Kind::residual(x.data(), c.data(), phi.data());
  return phi;
}

/// The power of the unit that takes one number to the other, if any.
std::optional<int> power(double one, double other, double unit) {
  constexpr double rounding = 1e-12;
  for (int p = least; p <= most; ++p)
    if (std::abs(other - one * std::pow(unit, p)) <= rounding * std::abs(other)) return p;
  return {};
}

/// The next choice of powers; false after the last.
bool advance(std::vector<int>& powers) {
  for (int& p : powers) {
    if (++p <= most) return true;
    p = least;
  }
  return false;
}

}  // namespace

std::optional<LengthPowers> length_powers(const Model& m, const Constraint& c) {
  constexpr double unit = 2;
  std::vector<bool> lengths;
  for (const EntityId id : c.operands) lengths.push_back(is_length(m.entities[id].kind));
  std::optional<LengthPowers> found;
  visit_kind(c.kind, [&]<class Kind>(Kind) {
    LengthPowers powers{std::vector<int>(Kind::constants, least), std::vector<int>(Kind::rows)};
    do {
      const auto one = residual<Kind>(lengths, powers.constants, 1);
      const auto other = residual<Kind>(lengths, powers.constants, unit);
      bool agree = true;
      for (int r = 0; r < Kind::rows && agree; ++r) {
        const auto of_row = power(one[r], other[r], unit);
        agree = of_row.has_value();
        powers.rows[r] = of_row.value_or(0);
      }
      if (agree) found = powers;
    } while (!found && advance(powers.constants));
  });
  return found;
}

}  // namespace desmo
