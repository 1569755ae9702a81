#include "formulations/verification/branch/singularity_crossing.h"

#include <algorithm>
#include <cmath>

#include "formulations/model/scales.h"

namespace desmo {

namespace {

/// Argument of a polynomial at s = h, where its arguments −1 and 1 are at s = −2h and −h.
constexpr double extension = 5;

/// Arc before the point at which the first node is, if a path leads there. Where it is too far, h
/// is halved.
constexpr double way_before = 2;

/// A miss of up to this times its rounding is hidden by it. Above, it is known to a factor of two.
constexpr double hiding_roundings = 2;

bool may_be_same(const Interval& a, const Interval& b) {
  return std::abs(a.mid - b.mid) <= a.radius + b.radius;
}

}  // namespace

/// Returns a number of a node with its radius.
Interval SingularityCrossing::number(const Node& node, Level level, int coordinate) {
  return {node.values[level][coordinate], node.radius[level][coordinate]};
}

SingularityCrossing::SingularityCrossing(const Model& m, const CertifiedInstant& last,
                                         std::span<const double> direction, GroupId group,
                                         TestBudget& budget)
    : budget_(budget),
      magnitudes_(nominal_magnitudes(m)),
      line_(m, last.values.position, direction, group),
      model_(m),
      before_(model_),
      beyond_(model_),
      refinement_(model_) {
  line_.lead(model_);
  if (line_.exists()) find_nodes(last);
}

/// Finds the first node, at most `way_before` from the point. The last instant is so near to the
/// point that no path leads back from it. So a path starts from a point of its Taylor polynomial.
/// That is on the same branch if the nodes, extended to s = 0, meet the last instant (leads_to()).
void SingularityCrossing::find_nodes(const CertifiedInstant& last) {
  const std::vector<double> zeros(model_.coordinates());
  const std::optional<Node> here = node({0, {last.values.position, zeros, zeros}, {}});
  if (!here) return;
  std::vector<double> q(here->values.position), acceleration(here->values.acceleration);
  // So near to the point rounding may leave not even a sign of second derivatives.
  for (std::size_t i = 0; i < acceleration.size(); ++i)
    if (!(std::abs(acceleration[i]) > here->radius.acceleration[i])) acceleration[i] = 0;
  for (double s = std::sqrt(Interval::unit); 2 * s < way_before && budget_.left() > 0; s *= 2) {
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] = here->values.position[i] - s * (here->values.velocity[i] - s / 2 * acceleration[i]);
    budget_.take();
    if (!before_.start_at({-s, {q, {}, {}}, {}})) continue;
    before_.go_to(-way_before, budget_);
    if (before_.present().time > -2 * s) continue;  // the first h would be less than s
    nodes_.clear();
    if (std::optional<Node> farthest = node(before_.present()))
      nodes_.push_back(std::move(*farthest));
    if (leads_to(*here, -s)) return;
  }
  nodes_.clear();
}

/// Returns whether the branch of the nodes leads to the instant `end` at s = 0. Adds nodes up to
/// s = nearest, and extends the polynomial through the last two.
bool SingularityCrossing::leads_to(const Node& end, double nearest) {
  if (nodes_.empty()) return false;
  int count = 2;
  while (std::ldexp(nodes_.front().s, -count) < nearest) ++count;
  if (!reach_nodes(count)) return false;
  const Node &far = nodes_[count - 2], &near = nodes_[count - 1];
  for (int i = 0; i < model_.coordinates(); ++i) {
    // The argument is 3 at s = 0. Compares rates, too: so near to the point, branches may differ by
    // these alone.
    Quintic<Interval> branch = polynomial(far, near, i);
    double unit = 1;
    for (const Level level : all_levels) {
      if (!may_be_same(value_at(branch, Interval(3)), number(end, level, i) * unit)) return false;
      branch = derivative(branch);
      unit *= (near.s - far.s) / 2;
    }
  }
  return true;
}

double SingularityCrossing::distance(int level) const {
  return std::ldexp(-nodes_.front().s, -1 - level);
}

/// Returns a copy of an instant with the radii of its rates; nothing where they are not proven.
std::optional<SingularityCrossing::Node> SingularityCrossing::node(
    const CertifiedInstant& instant) {
  budget_.take();
  const RefinedInstant& r = refinement_.refine(instant_of(instant.time, instant.values));
  if (!r.proven) return {};
  Node copy{instant.time, {}, {}};
  const PerLevel<std::span<const double>> values{r.instant.q, r.instant.qd, r.instant.qdd};
  for (const Level level : all_levels) {
    copy.values[level].assign(values[level].begin(), values[level].end());
    copy.radius[level].assign(r.radius[level].begin(), r.radius[level].end());
  }
  return copy;
}

/// Adds nodes before the point until there are `count`. Returns whether all are proven.
bool SingularityCrossing::reach_nodes(int count) {
  while (static_cast<int>(nodes_.size()) < count) {
    if (before_.go_to(nodes_.back().s / 2, budget_).end != PathEnd::same) return false;
    std::optional<Node> next = node(before_.present());
    if (!next) return false;
    nodes_.push_back(std::move(*next));
  }
  return true;
}

/// Returns the quintic through two nodes, with their radii. Its argument is −1 and 1 there.
Quintic<Interval> SingularityCrossing::polynomial(const Node& a, const Node& b, int i) const {
  const double half = (b.s - a.s) / 2;
  const auto end = [&](const Node& x) {
    return EndValues<Interval>{number(x, Level::position, i), number(x, Level::velocity, i) * half,
                               number(x, Level::acceleration, i) * (half * half)};
  };
  return hermite(end(a), end(b), Level::acceleration);
}

/// Compares the quintic through the two nodes of a level, extended beyond the point, with an
/// instant there.
SingularityCrossing::Miss SingularityCrossing::miss(int level, const Node& beyond) const {
  const Node &far = nodes_[level], &near = nodes_[level + 1];
  Miss result;
  for (int i = 0; i < model_.coordinates(); ++i) {
    const Interval extended = value_at(polynomial(far, near, i), Interval(extension));
    result.amount.push_back(std::abs(extended.mid - beyond.values.position[i]));
    result.rounding.push_back(extended.radius + beyond.radius.position[i]);
    result.is_hidden &= result.amount[i] <= hiding_roundings * result.rounding[i];
    result.shows_jumps &= result.rounding[i] < magnitudes_[i] * std::pow(beyond.s, 5);
  }
  return result;
}

/// Returns the largest ratio of the miss of a coordinate to its unit.
double SingularityCrossing::Miss::over(const std::vector<double>& unit) const {
  double largest = 0;
  for (std::size_t i = 0; i < unit.size(); ++i) largest = std::max(largest, amount[i] / unit[i]);
  return largest;
}

/// Ends at the latest where the distance, halved each time, falls to the roundoff u.
double SingularityCrossing::measure_fall(int level, std::span<const double> positions) {
  budget_.take();
  if (!beyond_.start_at({distance(level), {positions, {}, {}}, {}})) return 0;
  Miss last;
  double least = INFINITY, bottom = 0, deepest = 0;
  bool falls = true;
  for (int k = level;; ++k) {
    // At distances of the roundoff u, drivers are rounded to other points of the line: a path might
    // pass the change point unnoticed.
    const bool is_led = distance(k) > Interval::unit && reach_nodes(k + 2) &&
                        beyond_.go_to(distance(k), budget_).end == PathEnd::same;
    const std::optional<Node> end = is_led ? node(beyond_.present()) : std::nullopt;
    // Branches that would meet with exact lengths may pass each other closely: their miss grows
    // again towards the point. The miss of another branch that does meet falls all the way.
    if (!end) return !falls && deepest >= bottom ? least : 0;
    const Miss now = miss(k, *end);
    if (k == level) {
      about_ = {nodes_[k + 1].values.position, end->values.position};
      reach_ = end->s;
    }
    if (!falls) {
      deepest = now.over(last.rounding);
      continue;
    }
    // The first miss of a motion that is a quintic is hidden by rounding. That proves smoothness
    // only if a jump would be seen.
    if (now.is_hidden && k == level && !(level == 0 && now.shows_jumps)) return 0;
    const double coarse = k > level ? last.over(now.rounding) : 0;
    const double fine = std::max(now.over(now.rounding), hiding_roundings);
    if (k > level && coarse / fine < min_fall && !(now.is_hidden && k > level + 1)) {
      if (k == level + 1) return coarse / fine;
      falls = false;
      bottom = std::min(last.over(now.rounding), fine);
      last = now;
      continue;
    }
    if (k > level && !now.is_hidden) least = std::min(least, coarse / fine);
    join(nodes_[k + 1], *end);
    if (now.is_hidden) return std::max(least, min_fall);
    last = now;
  }
}

/// Lays the polynomials across the point, through a node before it and one beyond.
void SingularityCrossing::join(const Node& before, const Node& beyond) {
  width_ = beyond.s;
  positions_.resize(model_.coordinates());
  for (int i = 0; i < model_.coordinates(); ++i) {
    const Quintic<Interval> across = polynomial(before, beyond, i);
    std::ranges::transform(across, positions_[i].begin(), &Interval::mid);
  }
}

bool SingularityCrossing::find() {
  if (nodes_.empty()) return false;
  // At smaller h, rounding hides even jumps of the first derivative.
  for (int level = 0; distance(level) > std::sqrt(Interval::unit); ++level) {
    if (budget_.left() == 0 || !reach_nodes(level + 2)) return false;
    const Node &far = nodes_[level], &near = nodes_[level + 1];
    std::vector<double> beyond;
    for (int i = 0; i < model_.coordinates(); ++i)
      beyond.push_back(value_at(polynomial(far, near, i), Interval(extension)).mid);
    if (measure_fall(level, beyond) < min_fall) continue;
    beyond_.go_to(0, budget_);
    nearest_ = beyond_.present().time;
    return true;
  }
  return false;
}

const CertifiedInstant* SingularityCrossing::go_to(double s) {
  BranchPath& path = s > 0 ? beyond_ : before_;
  // Starts at a distance and goes towards the point: right next to it no path leads away.
  budget_.take();
  if (!path.start_at({std::copysign(reach_, s), {about_[s > 0], {}, {}}, {}})) return nullptr;
  return path.go_to(s, budget_).end == PathEnd::same ? &path.present() : nullptr;
}

}  // namespace desmo
