#include "formulations/verification/monitor/condition_monitor.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace desmo {

namespace {

/// Groups that the right-hand side hardly moves count as this part of the one that it moves most.
constexpr double min_part = 0.5;
/// By what part a distance, or the share of a group, may fall where a look holds.
constexpr double allowed = 0.5;
/// By then a distance may be zero: the way on which it halves counts as 1.
constexpr double singular = 1.5;
/// Slope of a distance over the way in magnitudes before it is known, and largest curvature.
constexpr double steepest = 2, curvature = 2;
/// Instead of infinity, which is not to be multiplied by 0.
constexpr double at_once = 1e300;
/// Looks kept, and numbers kept at most in all.
constexpr int max_looks = 128, max_look_numbers = 1 << 20;
/// Way in magnitudes that does not count: an instant has been corrected.
constexpr double negligible = 1e-6;
/// Instants after which coordinates are compared with those of the look.
constexpr int max_unmeasured = 16;
/// By how much rates between two instants may exceed those at both.
constexpr double rate_margin = 1.25;
/// Coordinates after which it is asked whether the rest matters.
constexpr Eigen::Index chunk = 32;

Eigen::Map<const Eigen::ArrayXd> mapped(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

/// Returns the largest of what is found for ranges (first, count) of n, or any from 1 on.
template <class Find>
double max_of_chunks(Eigen::Index n, Find&& find) {
  double result = 0;
  for (Eigen::Index i = 0; i < n && result < 1; i += chunk)
    result = std::max(result, find(i, std::min(chunk, n - i)));
  return result;
}

}  // namespace

ConditionMonitor::ConditionMonitor(const Model& m, const ScaledSystem& system,
                                   const Eigen::ArrayXd& row_magnitudes)
    : state_(m.state_size()),
      unit_(mapped(system.magnitudes()).head(m.coordinates()).inverse()),
      right_(system.size(), 4),
      x_(system.size(), 4),
      row_magnitudes_(row_magnitudes),
      way_(m.coordinates()),
      share_before_(m.groups.size()),
      way_of_group_(m.groups.size()),
      per_way_of_group_(m.groups.size()),
      then_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(m.groups.size()))),
      drivers_(Eigen::ArrayXd::Zero(m.coordinates())) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  std::mt19937 bits;  // of no pattern, so that next to nothing is at right angles to all
  for (int j = 0; j < system.size(); ++j) {
    group_.push_back(m.entities[entity[system.unknowns()[j]]].group);
    block_.push_back(system.block(j));
    for (int k = 0; k < right_.cols(); ++k) {
      const std::uint_fast32_t drawn = bits();
      const double size = 0.5 + (drawn & 0x7fffffffu) * 0x1p-32;
      right_(j, k) = drawn >> 31 ? -size : size;
    }
  }
  const int blocks = system.size() > 0 ? std::ranges::max(block_) + 1 : 0;
  distance_before_.resize(blocks);
  of_block_.resize(blocks);
  for (int j = 0; j < system.size(); ++j) of_block_[block_[j]] = group_[j];
  signs_.resize(blocks);
  make_looks();
  for (const Driver& d : m.drivers) {
    const int i = m.entities[d.coordinate].first;
    drivers_[i] = 1 / unit_[i];
  }
  for (const Entity& e : m.entities)
    if (!e.fixed && e.kind == EntityKind::angle) angles_.push_back(e.first);
  reads_.resize(m.groups.size());
  system.equations().jacobian<double>(std::vector<double>(m.state_size(), 1),
                                      [&](int row, int i, double) {
                                        if (i < m.coordinates())
                                          reads_[system.group_of_row(row)].push_back(i);
                                      });
  for (std::vector<int>& reads : reads_) {
    std::ranges::sort(reads);
    reads.erase(std::ranges::unique(reads).begin(), reads.end());
  }
}

void ConditionMonitor::make_looks() {
  const Eigen::Index n = unit_.size(), groups = then_.size(), blocks = distance_before_.size();
  const int count =
      std::clamp(max_look_numbers / (4 * std::max(1, static_cast<int>(n))), 2, max_looks);
  numbers_.resize(2 * n + groups + blocks, count);
  signs_of_looks_.resize(signs_.size() * count);
  for (int k = 0; k < count; ++k) {
    double* const x = numbers_.col(k).data();
    looks_.push_back(
        {.q = {x, n},
         .per_way = {x + n, n},
         .share = {x + 2 * n, groups},
         .distance = {x + 2 * n + groups, blocks},
         .signs = std::span(signs_of_looks_).subspan(k * signs_.size(), signs_.size())});
  }
}

/// Returns the part of the way that is used up.
double ConditionMonitor::used(const Look& look, std::span<const double> q) {
  return ((mapped(q) - look.q).abs() * look.per_way).maxCoeff();
}

/// Returns whether a look holds at q, whatever whole turns its angles are away, which it takes
/// away.
bool ConditionMonitor::turn_to(Look& look, std::span<const double> q) const {
  constexpr double turn = 2 * std::numbers::pi;
  for (const int i : angles_) look.q[i] += std::nearbyint((q[i] - look.q[i]) * (1 / turn)) * turn;
  const Eigen::Map<const Eigen::ArrayXd> now = mapped(q);
  Eigen::Index last = 0;
  const auto find = [&](Eigen::Index i, Eigen::Index n) {
    last = i;
    return ((now.segment(i, n) - look.q.segment(i, n)).abs() * look.per_way.segment(i, n))
        .maxCoeff();
  };
  const Eigen::Index first = look.decisive, few = std::min(chunk, now.size() - first);
  if (few > 0 && find(first, few) >= 1) return false;
  const bool holds = max_of_chunks(now.size(), find) < 1;
  if (!holds) look.decisive = last;
  return holds;
}

void ConditionMonitor::go_on(const Instant& instant, const Ways& ways) {
  if (count_ == 0) return;
  used_ +=
      rate_margin * std::max(ways.drivers * used_per_drivers_, ways.unknowns * used_per_unknowns_);
  if (used_ < 1 && ++unmeasured_ < max_unmeasured && !instant.interpolated) return;
  unmeasured_ = 0;
  used_ = used(looks_[current_], instant.q);
  if (used_ < 1) return;
  for (int k = 1; k < count_; ++k) {  // first the one that followed last time
    const int other = (current_ + k) % count_;
    if (!turn_to(looks_[other], instant.q)) continue;
    current_ = other;
    used_ = used(looks_[current_], instant.q);
    weigh_ways();
    return compare();
  }
}

void ConditionMonitor::look(const Instant& instant, ScaledSystem& system) {
  std::ranges::copy(instant.q, state_.begin());
  if (system.factor(state_)) {
    take(instant, system);
    return weigh_ways();
  }
  Look& singular = add(instant);
  singular.distance.setZero();
  singular.share.setConstant(INFINITY);
  singular.per_way.setConstant(at_once);
  singular.max_per_way = at_once;
  std::ranges::copy(signs_, singular.signs.begin());
  weigh_ways();
  compare();
}

/// Finds what part of the way is used up by what go_on() is told of.
void ConditionMonitor::weigh_ways() {
  const Look& look = looks_[current_];
  used_per_drivers_ = (look.per_way * drivers_).maxCoeff();
  used_per_unknowns_ = (look.per_way * unknowns_).maxCoeff();
}

double ConditionMonitor::way_left() const {
  const double per_way = count_ > 0 ? looks_[current_].max_per_way : 0;
  return (singular - std::min(1.0, used_)) / std::max(1e-300, per_way);
}

void ConditionMonitor::reset(const Instant& instant, ScaledSystem& system,
                             const Eigen::ArrayXd& weights) {
  unknowns_ = (weights > 0).select(weights.inverse(), 0);
  take(instant, system);
  weigh_ways();
  then_ = looks_[current_].share;
  std::ranges::copy(looks_[current_].signs, signs_.begin());
  growth_ = 1;
}

double ConditionMonitor::growth() const { return used_ > 0 ? growth_ / (1 - allowed) : growth_; }

void ConditionMonitor::compare() {
  const Look& look = looks_[current_];
  growth_ = std::ranges::equal(look.signs, signs_)
                ? std::max(1.0, (look.share / then_).maxCoeff<Eigen::PropagateNaN>())
                : INFINITY;
}

void ConditionMonitor::take(const Instant& instant, ScaledSystem& system) {
  const bool is_first = count_ == 0;
  if (!is_first) {
    const Look& last = looks_[current_];
    way_ = (mapped(instant.q) - last.q).abs() * unit_;
    if (!(way_.maxCoeff() > negligible)) return measure(looks_[current_], system);
    share_before_ = last.share;
    distance_before_ = last.distance;
  }
  Look& look = add(instant);
  measure(look, system);
  if (is_first) way_.setZero();
  schedule(look);
}

/// Returns the look that is now the current one, at an instant.
ConditionMonitor::Look& ConditionMonitor::add(const Instant& instant) {
  newest_ = (newest_ + 1) % static_cast<int>(looks_.size());
  count_ = std::min(count_ + 1, static_cast<int>(looks_.size()));
  current_ = newest_;
  used_ = 0;
  looks_[current_].q = mapped(instant.q);
  return looks_[current_];
}

void ConditionMonitor::measure(Look& look, ScaledSystem& system) {
  look.share.setZero();
  look.distance.setZero();
  if (system.size() > 0) {
    const auto largest = [&](int j) { return x_.row(j).abs().maxCoeff(); };
    const auto scale = [&] {  // by columns: all at once would take memory from the heap
      for (Eigen::Index k = 0; k < x_.cols(); ++k)
        x_.col(k) = right_.col(k) * (row_magnitudes_ / system.row_sums());
    };
    scale();
    system.solve(x_.data(), static_cast<int>(x_.cols()));
    for (int j = 0; j < system.size(); ++j)
      look.share[group_[j]] = std::max(look.share[group_[j]], largest(j));
    scale();
    system.solve_blocks(x_.data(), static_cast<int>(x_.cols()));
    for (int j = 0; j < system.size(); ++j)
      look.distance[block_[j]] = std::max(look.distance[block_[j]], largest(j));
  }
  look.share = look.share.max(min_part * look.share.maxCoeff());
  look.distance = look.distance.inverse();
  std::ranges::copy(system.orientation(), look.signs.begin());
  compare();
}

/// Finds around a look where it holds, from what has changed since the last one, way_ away.
void ConditionMonitor::schedule(Look& look) {
  const double way = way_.maxCoeff();
  look.per_way.setConstant(way > 0 ? 1 / until_grown(look, way) : 0);
  for (std::size_t g = 0; g < reads_.size(); ++g) {
    way_of_group_[g] = per_way_of_group_[g] = 0;
    for (const int i : reads_[g]) way_of_group_[g] = std::max(way_of_group_[g], way_[i]);
  }
  for (std::size_t b = 0; b < of_block_.size(); ++b) {
    const double d = look.distance[static_cast<Eigen::Index>(b)],
                 before = distance_before_[static_cast<Eigen::Index>(b)],
                 moved = way_of_group_[of_block_[b]];
    const double slope =
        moved > 0 ? std::abs(before - d) / moved + curvature / 2 * moved : steepest;
    double& per_way = per_way_of_group_[of_block_[b]];
    per_way = std::max(per_way, std::min(at_once, 1 / until_halved(d, slope)));
  }
  for (std::size_t g = 0; g < reads_.size(); ++g)
    for (const int i : reads_[g]) look.per_way[i] = std::max(look.per_way[i], per_way_of_group_[g]);
  look.max_per_way = look.per_way.maxCoeff();
  look.per_way *= unit_;
}

/// Returns the way on which a distance of that slope, at most, cannot halve.
double ConditionMonitor::until_halved(double distance, double slope) {
  // slope w + curvature w² / 2 = allowed d
  const double root = std::sqrt(slope * slope + 2 * curvature * allowed * distance);
  return (root - slope) / curvature;
}

/// Returns the way on which no group's share doubles at its last pace, in either direction.
double ConditionMonitor::until_grown(const Look& look, double way) const {
  const Eigen::ArrayXd& before = share_before_;
  const double pace =
      ((look.share / before).max(before / look.share) - 1).maxCoeff<Eigen::PropagateNaN>() / way;
  return pace > 0 ? allowed / pace : INFINITY;
}

}  // namespace desmo
