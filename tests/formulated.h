#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <string_view>

#include "formulations/base/state.h"
#include "formulations/id.h"

namespace desmo {

/// Makes the formulation of an id. base: settings that the id does not name.
inline std::unique_ptr<Formulation> formulated(std::string_view id, const Model& m,
                                               const Settings& base = {}) {
  const Configuration c = parse_id(id, base);
  return make_formulation(*c.variant, m, c.settings);
}
std::unique_ptr<Formulation> formulated(std::string_view, Model&&, const Settings& = {}) = delete;

/// Returns the larger of two errors; infinite where the second is not a number, which std::max()
/// would pass over.
inline double larger_error(double largest, double error) {
  return std::isnan(error) ? INFINITY : std::max(largest, error);
}

/// Returns the largest difference of two numbers, each over what `size` makes of the second;
/// infinite where one is not a number.
template <class Size>
double max_difference(std::span<const double> a, std::span<const double> b, Size size) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    largest = larger_error(largest, std::abs(a[i] - b[i]) / size(b[i]));
  return largest;
}
inline double max_difference(std::span<const double> a, std::span<const double> b) {
  return max_difference(a, b, [](double) { return 1; });
}
/// Relative to numbers that are larger than 1.
inline double max_relative_difference(std::span<const double> a, std::span<const double> b) {
  return max_difference(a, b, [](double x) { return std::max(1.0, std::abs(x)); });
}

/// Returns whether the instants solved last are the same to the last bit.
inline bool are_at_one_instant(const Formulation& f, const Formulation& g) {
  return std::ranges::equal(f.q(), g.q()) && std::ranges::equal(f.qd(), g.qd()) &&
         std::ranges::equal(f.qdd(), g.qdd());
}

/// Returns the state of a model at its estimate, at rest.
inline State state_at_estimate(const Model& m) {
  State s{m.estimate, {}, {}};
  s.q.insert(s.q.end(), m.fixed_values.begin(), m.fixed_values.end());
  s.qd.assign(s.q.size(), 0);
  s.qdd.assign(s.q.size(), 0);
  return s;
}

}  // namespace desmo
