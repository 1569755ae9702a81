#include "formulations/verification/monitor/condition_monitor.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace desmo {

namespace {

/// Groups that the right-hand side hardly moves count as this part of the one that it moves most.
constexpr double min_part = 0.5;
/// By what part a distance, or the share of a group, may fall from one look to the next.
constexpr double allowed = 0.5;
/// By then a distance may be zero: the way on which it halves counts as 1.
constexpr double singular = 1.5;
/// Slope of a distance over the way in magnitudes before it is known, and largest curvature.
constexpr double steepest = 2, curvature = 2;
/// Instead of infinity, which is not to be multiplied by 0.
constexpr double at_once = 1e300;

Eigen::Map<const Eigen::ArrayXd> mapped(std::span<const double> values) {
  return {values.data(), static_cast<Eigen::Index>(values.size())};
}

}  // namespace

ConditionMonitor::ConditionMonitor(const Model& m, const ScaledSystem& system)
    : state_(m.state_size()),
      unit_(mapped(system.magnitudes()).head(m.coordinates()).inverse()),
      last_(Eigen::ArrayXd::Constant(m.coordinates(), NAN)),
      way_(Eigen::ArrayXd::Zero(m.coordinates())),
      per_way_(way_),
      x_(system.size()),
      now_(Eigen::ArrayXd::Zero(static_cast<Eigen::Index>(m.groups.size()))),
      then_(now_),
      before_(now_) {
  std::ranges::copy(m.fixed_values, state_.begin() + m.coordinates());
  const std::vector<EntityId> entity = entity_of_coordinate(m);
  std::mt19937 bits;  // of no pattern, so that next to nothing is at right angles to all
  for (Eigen::ArrayXd& right : right_) right.resize(system.size());
  for (int j = 0; j < system.size(); ++j) {
    group_.push_back(m.entities[entity[system.unknowns()[j]]].group);
    block_.push_back(system.block(j));
    for (Eigen::ArrayXd& right : right_) {
      const std::uint_fast32_t drawn = bits();
      const double size = 0.5 + (drawn & 0x7fffffffu) * 0x1p-32;
      right[j] = drawn >> 31 ? -size : size;
    }
  }
  const int blocks = system.size() > 0 ? std::ranges::max(block_) + 1 : 0;
  distance_ = distance_before_ = Eigen::ArrayXd::Zero(blocks);
  of_block_.resize(blocks);
  for (int j = 0; j < system.size(); ++j) of_block_[block_[j]] = group_[j];
  reads_.resize(m.groups.size());
  way_before_ = now_;
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

void ConditionMonitor::go_on(const Instant& instant) {
  if (last_.size() == 0) return;
  if (!std::isnan(last_[0])) way_ += (mapped(instant.q) - last_).abs() * unit_;
  last_ = mapped(instant.q);
  used_ = (way_ * per_way_).maxCoeff();
}

void ConditionMonitor::look(const Instant& instant, ScaledSystem& system) {
  std::ranges::copy(instant.q, state_.begin());
  if (system.factor(state_)) {
    take(system);
    if (!std::ranges::equal(system.orientation(), signs_)) growth_ = INFINITY;
    return;
  }
  growth_ = INFINITY;
  distance_.setZero();
  per_way_.setConstant(at_once);
  max_per_way_ = at_once;
}

double ConditionMonitor::way_left() const {
  return (singular - std::min(1.0, used_)) / std::max(1e-300, max_per_way_);
}

void ConditionMonitor::reset(ScaledSystem& system) {
  take(system);
  then_ = now_;
  signs_.assign(system.orientation().begin(), system.orientation().end());
  growth_ = 1;
}

double ConditionMonitor::growth() const { return growth_ / (1 - allowed * std::min(1.0, used_)); }

void ConditionMonitor::take(ScaledSystem& system) {
  if (system.size() == 0) return;
  if (double way = way_.maxCoeff(); way > 0) {  // else it is the same position
    all_way_before_ = way;
    before_ = now_;
    distance_before_ = distance_;
    for (std::size_t g = 0; g < reads_.size(); ++g) {
      way = 0;
      for (const int i : reads_[g]) way = std::max(way, way_[i]);
      way_before_[static_cast<Eigen::Index>(g)] = way;
    }
  }
  way_.setZero();
  used_ = 0;
  now_.setZero();
  for (const Eigen::ArrayXd& right : right_) {
    x_ = right;
    system.solve(x_.data());
    for (int j = 0; j < system.size(); ++j)
      now_[group_[j]] = std::max(now_[group_[j]], std::abs(x_[j]));
  }
  now_ = now_.max(min_part * now_.maxCoeff());
  growth_ = std::max(1.0, (now_ / then_).maxCoeff());
  measure_distances(system);
  schedule();
}

void ConditionMonitor::measure_distances(ScaledSystem& system) {
  distance_.setZero();  // of 1/d, at first
  for (const Eigen::ArrayXd& right : right_) {
    x_ = right;
    system.solve_blocks(x_.data());
    for (int j = 0; j < system.size(); ++j)
      distance_[block_[j]] = std::max(distance_[block_[j]], std::abs(x_[j]));
  }
  distance_ = distance_.inverse();
}

void ConditionMonitor::schedule() {
  per_way_.setConstant(1 / until_grown());
  per_way_of_group_.assign(reads_.size(), 0);
  for (std::size_t b = 0; b < of_block_.size(); ++b) {
    double& per_way = per_way_of_group_[of_block_[b]];
    per_way = std::max(per_way, std::min(at_once, 1 / until_halved(static_cast<int>(b))));
  }
  for (std::size_t g = 0; g < reads_.size(); ++g)
    for (const int i : reads_[g]) per_way_[i] = std::max(per_way_[i], per_way_of_group_[g]);
  max_per_way_ = per_way_.maxCoeff();
}

/// Returns the way on which the distance of a block cannot halve. A motion may turn back, so its
/// slope counts either way.
double ConditionMonitor::until_halved(int b) const {
  double slope = steepest;  // of the fall, at most
  if (const double way = way_before_[of_block_[b]]; way > 0)
    slope = std::abs(distance_before_[b] - distance_[b]) / way + curvature / 2 * way;
  // slope w + curvature w² / 2 = allowed d
  const double root = std::sqrt(slope * slope + 2 * curvature * allowed * distance_[b]);
  return (root - slope) / curvature;
}

/// Returns the way on which no group's share doubles at its last pace.
double ConditionMonitor::until_grown() const {
  if (!(all_way_before_ > 0)) return INFINITY;
  const double pace = (now_ / before_ - 1).abs().maxCoeff() / all_way_before_;
  return pace > 0 ? allowed / pace : INFINITY;
}

}  // namespace desmo
