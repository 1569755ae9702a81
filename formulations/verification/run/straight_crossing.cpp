#include "formulations/verification/run/straight_crossing.h"

#include <algorithm>
#include <cmath>

#include "formulations/scaling/scales.h"

namespace desmo {

namespace {

/// Instants at −2h and −h are at −1 and 1 of a polynomial's argument; then h is here.
constexpr double extension = 5;

Model with_drivers_on(const DriverLine& line, Model m) {
  for (std::size_t k = 0; k < m.drivers.size(); ++k)
    m.drivers[k].motion = Polynomial{{line.origin[k], line.rates[k]}};
  return m;
}

std::vector<double> of_drivers(const Model& m, std::span<const double> coordinates) {
  std::vector<double> result;
  for (const Driver& d : m.drivers) result.push_back(coordinates[m.entities[d.coordinate].first]);
  return result;
}

}  // namespace

DriverLine::DriverLine(const Model& m, std::span<const double> from,
                       std::span<const double> direction)
    : magnitudes(of_drivers(m, natural_magnitudes(m))),
      origin(from.begin(), from.end()),
      rates(direction.begin(), direction.end()) {
  double largest = 0;
  for (std::size_t k = 0; k < rates.size(); ++k)
    largest = std::max(largest, std::abs(rates[k]) / magnitudes[k]);
  for (double& x : rates) x /= largest;
  const double length = std::sqrt(along(rates));
  for (double& x : rates) x /= length;
}

bool DriverLine::exists() const {
  return std::ranges::all_of(rates, [](double x) { return std::isfinite(x); });
}

double DriverLine::along(std::span<const double> change) const {
  double sum = 0;
  for (std::size_t k = 0; k < rates.size(); ++k)
    sum += change[k] / magnitudes[k] * (rates[k] / magnitudes[k]);
  return sum;
}

double DriverLine::arc(std::span<const double> z) const {
  std::vector<double> change(z.begin(), z.end());
  for (std::size_t k = 0; k < change.size(); ++k) change[k] -= origin[k];
  return along(change);
}

std::vector<double> DriverLine::at(double s) const {
  std::vector<double> z = origin;
  for (std::size_t k = 0; k < z.size(); ++k) z[k] += s * rates[k];
  return z;
}

double DriverLine::distance(std::span<const double> z, double s) const {
  double squares = 0;
  for (std::size_t k = 0; k < rates.size(); ++k) {
    const double off = (z[k] - origin[k] - s * rates[k]) / magnitudes[k];
    squares += off * off;
  }
  return std::sqrt(squares);
}

StraightCrossing::StraightCrossing(const Model& m, const CertifiedInstant& last,
                                   std::span<const double> direction)
    : magnitudes_(natural_magnitudes(m)),
      line_(m, of_drivers(m, last.values.position), direction),
      model_(with_drivers_on(line_, m)),
      before_(model_),
      beyond_(model_),
      refinement_(model_),
      no_rates_(m.coordinates()) {
  if (line_.exists()) find_nodes(last);
}

/// Goes back from the point as far as the mechanism moves. The last instant itself is so near to
/// the point that no path leads back from it. Taylor's polynomial leads to another one; that both
/// are on the same branch is told by the motion, which leads smoothly from the one to the other.
void StraightCrossing::find_nodes(const CertifiedInstant& last) {
  const std::optional<Node> here = node({0, {last.values.position, no_rates_, no_rates_}, {}});
  if (!here) return;
  std::vector<double> q(here->values.position);
  for (double s = std::sqrt(Interval::unit); s < 1; s *= 2) {
    for (std::size_t i = 0; i < q.size(); ++i)
      q[i] = here->values.position[i] -
             s * (here->values.velocity[i] - s / 2 * here->values.acceleration[i]);
    if (!before_.start_at({-s, {q, {}, {}}, {}})) continue;
    // Two units of arc are as good as any: a way that is too long is halved.
    before_.go_to(-2);
    if (before_.present().time > -8 * s) continue;  // too few halvings
    nodes_.clear();
    if (std::optional<Node> farthest = node(before_.present()))
      nodes_.push_back(std::move(*farthest));
    if (leads_to(*here, -s)) return;
  }
  nodes_.clear();
}

/// Returns whether the branch of the nodes, up to that s, leads to an instant at s = 0.
bool StraightCrossing::leads_to(const Node& end, double nearest) {
  if (nodes_.empty()) return false;
  int count = 2;
  while (std::ldexp(nodes_.front().s, -count) < nearest) ++count;
  if (!reach_nodes(count)) return false;
  const Node &far = nodes_[count - 2], &near = nodes_[count - 1];
  for (int i = 0; i < model_.coordinates(); ++i) {
    // From −2h and −h to 0: the argument is 3.
    const Interval extended = value_at(polynomial(far, near, i), Interval(3));
    const double miss = std::abs(extended.mid - end.values.position[i]);
    if (!(miss <= extended.radius + end.radius.position[i])) return false;
  }
  return true;
}

double StraightCrossing::distance(int level) const {
  return std::ldexp(-nodes_.front().s, -1 - level);
}

/// Returns a copy of an instant with the radii of its rates; nothing where they are not proven.
std::optional<StraightCrossing::Node> StraightCrossing::node(const CertifiedInstant& instant) {
  const RefinedInstant& r = refinement_.refine({.index = 0,
                                                .time = instant.time,
                                                .q = instant.values.position,
                                                .qd = instant.values.velocity,
                                                .qdd = instant.values.acceleration});
  if (!r.proven) return {};
  Node copy{instant.time, {}, {}};
  const PerLevel<std::span<const double>> values{r.instant.q, r.instant.qd, r.instant.qdd};
  for (const Level level : all_levels) {
    copy.values[level].assign(values[level].begin(), values[level].end());
    copy.radius[level].assign(r.radius[level].begin(), r.radius[level].end());
  }
  return copy;
}

/// Finds nodes before the point until there are that many. Returns whether they are proven.
bool StraightCrossing::reach_nodes(int count) {
  while (static_cast<int>(nodes_.size()) < count) {
    if (before_.go_to(nodes_.back().s / 2).end != PathEnd::same) return false;
    std::optional<Node> next = node(before_.present());
    if (!next) return false;
    nodes_.push_back(std::move(*next));
  }
  return true;
}

/// Returns the quintic through two nodes, with their radii. Its argument is −1 and 1 there.
Quintic<Interval> StraightCrossing::polynomial(const Node& a, const Node& b, int i) const {
  const double half = (b.s - a.s) / 2;
  const auto end = [&](const Node& x) {
    const auto value = [&](Level level) {
      return Interval(x.values[level][i], x.radius[level][i]);
    };
    return EndValues<Interval>{value(Level::position), value(Level::velocity) * half,
                               value(Level::acceleration) * (half * half)};
  };
  return hermite(end(a), end(b), Level::acceleration);
}

double StraightCrossing::fall(int level, std::span<const double> positions) {
  if (!beyond_.start_at({distance(level), {positions, {}, {}}, {}})) return 0;
  const int n = model_.coordinates();
  std::vector<double> last(n), miss(n), radius(n);
  double least = INFINITY;
  for (int k = level;; ++k) {
    if (!reach_nodes(k + 2) || beyond_.go_to(distance(k)).end != PathEnd::same) return 0;
    const Node &far = nodes_[k], &near = nodes_[k + 1];
    const std::optional<Node> end = node(beyond_.present());
    if (!end) return 0;
    double coarse = 0, fine = 0;  // the last miss and this one, in roundings
    bool shows_jumps = true;      // of the fifth derivative
    for (int i = 0; i < n; ++i) {
      const Interval extended = value_at(polynomial(far, near, i), Interval(extension));
      miss[i] = std::abs(extended.mid - end->values.position[i]);
      radius[i] = extended.radius + end->radius.position[i];
      fine = std::max(fine, miss[i] / radius[i]);
      coarse = std::max(coarse, last[i] / radius[i]);
      shows_jumps &= radius[i] < magnitudes_[i] * std::pow(end->s, 5);
    }
    if (k == level) {
      about_ = {near.values.position, end->values.position};
      reach_ = end->s;
    }
    // Rounding makes up to one: it at most halves the fall of what is more.
    const bool is_hidden = fine <= 2;
    // What is a quintic itself is extended without a miss.
    if (is_hidden && k == level && !(level == 0 && shows_jumps)) return 0;
    if (k > level && !(is_hidden && k > level + 1)) {
      least = std::min(least, coarse / std::max(fine, 2.0));
      if (!(least >= min_fall)) return least;
    }
    if (is_hidden) {
      width_ = end->s;
      positions_.resize(n);
      for (int i = 0; i < n; ++i) {
        const Quintic<Interval> across = polynomial(near, *end, i);
        std::ranges::transform(across, positions_[i].begin(), &Interval::mid);
      }
      return least;
    }
    last.swap(miss);
  }
}

bool StraightCrossing::find() {
  if (nodes_.empty()) return false;
  // Nearer to the point, rounding hides what even the first derivative does.
  for (int level = 0; distance(level) > std::sqrt(Interval::unit); ++level) {
    if (!reach_nodes(level + 2)) return false;
    const Node &far = nodes_[level], &near = nodes_[level + 1];
    std::vector<double> beyond;
    for (int i = 0; i < model_.coordinates(); ++i)
      beyond.push_back(value_at(polynomial(far, near, i), Interval(extension)).mid);
    if (fall(level, beyond) < min_fall) continue;
    beyond_.go_to(0);
    nearest_ = beyond_.present().time;
    return true;
  }
  return false;
}

const CertifiedInstant* StraightCrossing::go_to(double s) {
  BranchPath& path = s > 0 ? beyond_ : before_;
  // Towards the point: next to it no path leads away.
  if (!path.start_at({std::copysign(reach_, s), {about_[s > 0], {}, {}}, {}})) return nullptr;
  return path.go_to(s).end == PathEnd::same ? &path.present() : nullptr;
}

}  // namespace desmo
