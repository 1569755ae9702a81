#include "bench/suite/verification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace desmo::suite {

namespace {

constexpr int instants_compared = 51;

/// What is missing counts as infinitely wrong.
double largest_difference(std::span<const double> a, std::span<const double> b) {
  if (a.size() != b.size()) return INFINITY;
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) widen(largest, a[i], b[i]);
  return largest;
}

}  // namespace

void widen(double& largest, double a, double b) {
  const double d = std::abs(a - b);
  if (!(d <= largest)) largest = std::isnan(d) ? INFINITY : d;
}

void VerifyingSink::accept(const Instant& instant) {
  if (static_cast<std::size_t>(errors_.instants) == reference_.size()) return;
  const ReferenceInstant& r = reference_[errors_.instants];
  if (instant.time != r.time) return;
  ++errors_.instants;
  errors_.position = std::max(errors_.position, largest_difference(instant.q, r.q));
  errors_.velocity = std::max(errors_.velocity, largest_difference(instant.qd, r.qd));
  errors_.acceleration = std::max(errors_.acceleration, largest_difference(instant.qdd, r.qdd));
}

std::string complaint(const Errors& e, std::size_t expected_instants) {
  if (static_cast<std::size_t>(e.instants) != expected_instants)
    return "compared with the reference at " + std::to_string(e.instants) +
           " instants instead of " + std::to_string(expected_instants);
  if (e.position <= allowed.position && e.velocity <= allowed.velocity &&
      e.acceleration <= allowed.acceleration)
    return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "differs from the quadruple reference by %.1e in position, %.1e in velocity, %.1e "
                "in acceleration (allowed: %.0e, %.0e, %.0e)",
                e.position, e.velocity, e.acceleration, allowed.position, allowed.velocity,
                allowed.acceleration);
  return text;
}

std::string missing_code(const Formulation& f) {
  int missing = 0;
  std::string first;
  for (const auto& part : f.parts()) {
    if (part.as_named) continue;
    if (missing++ == 0) first = f.mechanism().groups[part.definition.groups.front()].name;
  }
  if (missing == 0) return {};
  return "no generated code for " + std::to_string(missing) + " of " +
         std::to_string(f.parts().size()) + " parts, first of group '" + first + "'";
}

std::span<const ReferenceInstant> ReferenceCache::get(const Mechanism& m, const TimeGrid& grid) {
  std::vector<ReferenceInstant>& reference = cache_[{m.name, m.coordinates()}];
  if (reference.empty()) {
    const int count = std::min(grid.instants, instants_compared);
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
      times.push_back(grid.time(
          count == 1 ? 0
                     : static_cast<int>(static_cast<long>(i) * (grid.instants - 1) / (count - 1))));
    reference = reference_solution(m, times, Precision::quadruple);
  }
  return reference;
}

}  // namespace desmo::suite
