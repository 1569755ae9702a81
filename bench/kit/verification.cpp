#include "bench/kit/verification.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>
#include <tuple>
#include <utility>

#include "bench/kit/digests.h"
#include "cases/mechanism/formatted.h"
#include "formulations/model/scales.h"
#include "formulations/motion/internals.h"
#include "formulations/runtime/digest.h"

namespace desmo::bench {

namespace {

constexpr int instants_compared = 51;  // largest number of instants of a shared reference
/// Allowed difference (≤) of two quadruple solutions, relative to the mechanism's scales.
constexpr double max_floor = 1e-20;

}  // namespace

void raise_to_difference(double& largest, double a, double b) {
  const double d = std::abs(a - b);
  if (!(d <= largest)) largest = std::isnan(d) ? INFINITY : d;
}

ComparingObserver::ComparingObserver(std::size_t coordinates, Level level,
                                     std::span<const ReferenceInstant> reference,
                                     std::vector<Compared> compared)
    : Delivery(coordinates, level),
      reference_(reference),
      copies_(reference.size()),
      compared_(std::move(compared)) {
  for (auto& [was_delivered, state] : copies_) state.resize(coordinates);
}

Flow ComparingObserver::observe(const Instant& i) noexcept {
  const auto r = std::ranges::lower_bound(reference_, i.time, {}, &ReferenceInstant::time);
  if (r != reference_.end() && r->time == i.time) {
    auto& [was_delivered, state] = copies_[r - reference_.begin()];
    was_delivered = true;
    std::ranges::copy(i.q, state.q.begin());
    std::ranges::copy(i.qd, state.qd.begin());
    std::ranges::copy(i.qdd, state.qdd.begin());
  }
  return Delivery::observe(i);
}

Comparison ComparingObserver::compare() const {
  Differences errors;
  Digest results;
  for (std::size_t r = 0; r < copies_.size(); ++r) {
    const auto& [was_delivered, state] = copies_[r];
    if (!was_delivered) continue;
    ++errors.instants;
    for (const auto& [delivered, reference, level, scale] : compared_) {
      const double value = values_at(state, level)[delivered];
      const double right = values_at(reference_[r], level)[reference];
      raise_to_difference(errors[level], value / scale, right / scale);
      const auto multiple = nearest_multiple(value, right, allowed_difference[level] * scale);
      results.add(std::to_string(multiple) + ' ');
    }
  }
  return {errors, results.hex()};
}

std::vector<Compared> all_compared(std::size_t coordinates, Level highest,
                                   const PerLevel<std::vector<double>>& scales) {
  std::vector<Compared> all;
  all.reserve(3 * coordinates);
  for (const Level level : all_levels) {
    if (level > highest) break;
    for (int i = 0; i < static_cast<int>(coordinates); ++i)
      all.push_back({i, i, level, scales[level].empty() ? 1 : scales[level][i]});
  }
  return all;
}

PerLevel<std::vector<double>> coordinate_scales(const Model& m,
                                                std::span<const ReferenceInstant> reference) {
  const Scales scales = make_scales(m, reference);
  PerLevel<std::vector<double>> all;
  for (const Level level : all_levels) {
    all[level].assign(m.coordinates(), 1);
    for (const Entity& e : m.entities)
      if (const double scale = scales.of(e.kind, level); !e.fixed && scale > 0)
        std::fill_n(all[level].begin() + e.first, e.size, scale);
  }
  return all;
}

std::string verification_failure(const Differences& e, std::size_t expected_instants,
                                 double times) {
  const PerLevel<double> bound{times * allowed_difference.position,
                               times * allowed_difference.velocity,
                               times * allowed_difference.acceleration};
  if (static_cast<std::size_t>(e.instants) != expected_instants)
    return "compared with the reference at " + std::to_string(e.instants) +
           " instants instead of " + std::to_string(expected_instants);
  if (std::ranges::all_of(all_levels, [&](Level level) { return e[level] <= bound[level]; }))
    return {};
  return formatted(
      "differs from the reference by %.1e in position, %.1e in velocity, %.1e "
      "in acceleration (allowed: %.0e, %.0e, %.0e)",
      e.position, e.velocity, e.acceleration, bound.position, bound.velocity, bound.acceleration);
}

void require_agreement(const Model& m, const PerLevel<double>& floor) {
  for (const Level level : all_levels) {
    if (floor[level] <= max_floor) continue;
    throw std::runtime_error(m.name + ": no reference: two quadruple solutions differ by " +
                             formatted("%.1e of the scale", floor[level]));
  }
}

std::string missing_code(const Formulation& f) {
  const std::vector<DefinedPart>& parts = parts_of(f);
  const auto first = std::ranges::find(parts, false, &DefinedPart::as_named);
  if (first == parts.end()) return {};
  const auto missing = std::ranges::count(parts, false, &DefinedPart::as_named);
  return "no generated code for " + std::to_string(missing) + " of " +
         std::to_string(parts.size()) + " parts, first of group '" +
         f.model().groups[first->definition.groups.front()].name + "'";
}

std::vector<double> spread_times(const TimeGrid& grid, int count) {
  const long last = grid.instants - 1, pieces = count - 1;
  std::vector<double> times;
  for (long i = 0; i < pieces; ++i) {
    const long begin = i * last / pieces, end = (i + 1) * last / pieces;
    const double turns = static_cast<double>(i) * std::numbers::phi;  // fractions: all over [0, 1)
    const double part = (turns - std::floor(turns)) * static_cast<double>(end - begin);
    times.push_back(grid.time(static_cast<int>(begin + static_cast<long>(part))));
  }
  times.push_back(grid.time(static_cast<int>(last)));
  return times;
}

std::span<const ReferenceInstant> shared_reference(const Model& m, const TimeGrid& grid,
                                                   int stride) {
  // References by model_digest(), start and step of the grid [s], its instants, and whether it is
  // strided.
  static std::map<std::tuple<std::string, double, double, int, bool>, Reference> all;
  const bool is_strided = stride > 1;
  Reference& reference = all[{model_digest(m), grid.start, grid.step, grid.instants, is_strided}];
  if (reference.instants.empty()) {
    const int count = std::min(grid.instants, instants_compared);
    std::vector<double> times;
    if (is_strided && count > 1) {
      times = spread_times(grid, count);
    } else {
      const long last = grid.instants - 1, pieces = std::max(1, count - 1);
      for (long i = 0; i < count; ++i)
        times.push_back(grid.time(static_cast<int>(i * last / pieces)));
    }
    Reference made = make_reference(m, times);
    require_agreement(m, made.floor);
    reference = std::move(made);
  }
  return reference.instants;
}

}  // namespace desmo::bench
