#include "bench/kit/verification.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <utility>

namespace desmo::bench {

namespace {

constexpr int instants_compared = 51;
/// Allowed difference of two quadruple solutions, relative to the mechanism's scales.
constexpr double highest_floor = 1e-20;

void compare(double& largest, ResultDigest& results, std::span<const double> found,
             std::span<const double> reference, double unit) {
  for (std::size_t i = 0; i < reference.size(); ++i) {
    widen(largest, found[i], reference[i]);
    results.add(found[i], reference[i], unit);
  }
}

}  // namespace

void widen(double& largest, double a, double b) {
  const double d = std::abs(a - b);
  if (!(d <= largest)) largest = std::isnan(d) ? INFINITY : d;
}

Flow ComparingObserver::observe(const Instant& i) noexcept {
  const auto r = std::ranges::lower_bound(reference_, i.time, {}, &ReferenceInstant::time);
  if (r != reference_.end() && r->time == i.time) {
    const auto copy = [](std::span<const double> v) { return std::vector(v.begin(), v.end()); };
    came_[r - reference_.begin()] = {copy(i.q), copy(i.qd), copy(i.qdd)};
  }
  return Delivery::observe(i);
}

VerifyingObserver::VerifyingObserver(std::span<const ReferenceInstant> reference)
    : ComparingObserver(reference.empty() ? 0 : reference.front().q.size(), Level::acceleration,
                        reference) {}

Comparison VerifyingObserver::compare() const {
  Errors errors;
  ResultDigest results;
  for_each([&](const ReferenceInstant& r, const State& came) {
    ++errors.instants;
    bench::compare(errors.position, results, came.q, r.q, allowed.position);
    bench::compare(errors.velocity, results, came.qd, r.qd, allowed.velocity);
    bench::compare(errors.acceleration, results, came.qdd, r.qdd, allowed.acceleration);
  });
  return {errors, results.hex()};
}

std::string verification_failure(const Errors& e, std::size_t expected_instants, double times) {
  const Errors bound{0, times * allowed.position, times * allowed.velocity,
                     times * allowed.acceleration};
  if (static_cast<std::size_t>(e.instants) != expected_instants)
    return "compared with the reference at " + std::to_string(e.instants) +
           " instants instead of " + std::to_string(expected_instants);
  if (e.position <= bound.position && e.velocity <= bound.velocity &&
      e.acceleration <= bound.acceleration)
    return {};
  char text[200];
  std::snprintf(text, sizeof text,
                "differs from the reference by %.1e in position, %.1e in velocity, %.1e "
                "in acceleration (allowed: %.0e, %.0e, %.0e)",
                e.position, e.velocity, e.acceleration, bound.position, bound.velocity,
                bound.acceleration);
  return text;
}

void require_agreement(const Model& m, const PerLevel<double>& floor) {
  for (const Level level : levels) {
    if (floor[level] <= highest_floor) continue;
    char text[32];
    std::snprintf(text, sizeof text, "%.1e", floor[level]);
    throw std::runtime_error(m.name + ": no reference: two quadruple solutions differ by " + text +
                             " of the scale");
  }
}

std::string missing_code(const Formulation& f) {
  int missing = 0;
  std::string first;
  for (const auto& part : f.parts()) {
    if (part.as_named) continue;
    if (missing++ == 0) first = f.model().groups[part.definition.groups.front()].name;
  }
  if (missing == 0) return {};
  return "no generated code for " + std::to_string(missing) + " of " +
         std::to_string(f.parts().size()) + " parts, first of group '" + first + "'";
}

std::span<const ReferenceInstant> ReferenceCache::get(const Model& m, const TimeGrid& grid) {
  Reference& reference = cache_[{m.name, m.coordinates(), grid.start, grid.step, grid.instants}];
  if (reference.instants.empty()) {
    const int count = std::min(grid.instants, instants_compared);
    std::vector<double> times;
    for (int i = 0; i < count; ++i)
      times.push_back(grid.time(
          count == 1 ? 0
                     : static_cast<int>(static_cast<long>(i) * (grid.instants - 1) / (count - 1))));
    Reference made = make_reference(m, times);
    require_agreement(m, made.floor);
    reference = std::move(made);
  }
  return reference.instants;
}

}  // namespace desmo::bench
