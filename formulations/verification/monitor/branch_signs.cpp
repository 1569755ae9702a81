#include "formulations/verification/monitor/branch_signs.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Blocks of so few unknowns have two solutions at most, mirror images with determinants of
/// different sign: a point by two distances in the plane, with the angle of one; by three in space.
constexpr int mirrored = 3;
/// Of the distance to another solution, how far an estimate may be off.
constexpr double near = 0.4;

}  // namespace

void BranchSigns::declare(const Instant& first) {
  std::vector<double> state = model_.estimate;
  state.insert(state.end(), model_.fixed_values.begin(), model_.fixed_values.end());
  for (const Driver& d : model_.drivers) {
    const int i = model_.entities[d.coordinate].first;
    state[i] = first.q[i];
  }
  if (!system_.factor(state)) return;
  begin();
}

void BranchSigns::begin() {
  const auto now = system_.orientation();
  signs_.assign(now.begin(), now.end());
  found_ = before_ = signs_;
}

std::optional<SingularityCrossing> BranchSigns::at_first(const Instant& instant,
                                                         const Assessment& assessment,
                                                         double sensitivity) {
  const std::optional<SingularityCrossing> other = change(instant.time, {});
  if (is_near_estimate(instant, assessment.condition, sensitivity)) return other;
  return SingularityCrossing{instant.time, instant.time, assessment.group,
                             SingularityCrossing::Kind::not_declared};
}

int BranchSigns::changed_block() const {
  const auto now = system_.orientation();
  const auto change = std::ranges::mismatch(signs_, now).in1;
  return change == signs_.end() ? -1 : static_cast<int>(change - signs_.begin());
}

std::optional<SingularityCrossing> BranchSigns::change(double time, std::optional<double> since) {
  std::optional<SingularityCrossing> found;
  if (const int block = changed_block(); block >= 0)
    found = {since.value_or(time), time, system_.group_of_block(block),
             since ? SingularityCrossing::Kind::passed : SingularityCrossing::Kind::not_declared};
  const auto now = system_.orientation();
  found_.assign(now.begin(), now.end());
  return found;
}

void BranchSigns::accept() {
  before_ = signs_;
  if (!found_.empty()) signs_ = found_;
}

/// Whether the way from the estimate is short, but for what the drivers have moved since: against
/// a link where two mirror images are all that there is, which signs tell apart, and else against
/// the distance of the next singular position, of the order of 1 / κ. Links are as long as they
/// are where they have been assembled: an estimate that is far off stretches them.
bool BranchSigns::is_near_estimate(const Instant& instant, double condition,
                                   double sensitivity) const {
  const std::vector<double> magnitude = system_.magnitudes_at(instant.q);
  const auto moved = [&](int i) {
    return std::abs(instant.q[i] - model_.estimate[i]) / magnitude[i];
  };
  double by_drivers = 0;
  for (const Driver& d : model_.drivers)
    by_drivers = std::max(by_drivers, moved(model_.entities[d.coordinate].first));
  for (int j = 0; j < system_.size(); ++j) {
    const double nearest = system_.block_size(j) <= mirrored ? 1 : 1 / condition;
    if (moved(system_.unknowns()[j]) > near * nearest + 2 * sensitivity * by_drivers) return false;
  }
  return true;
}

}  // namespace desmo
