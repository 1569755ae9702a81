#include "formulations/verification/range/double_roots.h"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <cmath>
#include <utility>

#include "formulations/verification/range/singular_points.h"

namespace desmo {

using Point = SolutionCurve::Point;

std::optional<ChangePoint> DoubleRootSearch::add(const Point& point, const Determinants& there,
                                                 double length) {
  since_ += length;
  // A middle point too near to an outer one tells nothing: waits for a later point.
  if (last_.size() > 1 && since_ < last_.back().length / 2) return {};
  last_.push_back({point, std::exchange(since_, 0), there});
  if (last_.size() < 3) return {};
  std::optional<ChangePoint> found;
  for (int block = 0; block < std::ssize(there.signs) && !found; ++block) {
    if (!may_have_root(block)) continue;
    if (const auto value = value_of_root(block, least(block)))
      found = ChangePoint{*value, determinants_.group(block), true};
  }
  last_.erase(last_.begin());
  return found;
}

/// Returns whether √|det| is smallest at the middle point, and nearer to line 1 than to line 2.
/// Both go through the outer points. For line 1 the sign of one of these is changed.
bool DoubleRootSearch::may_have_root(int block) const {
  const double a = last_[0].root(block), b = last_[1].root(block), c = last_[2].root(block),
               share = last_[1].length / (last_[1].length + last_[2].length);
  return b <= a && b <= c && b < std::max(share * c, (1 - share) * a);
}

/// Returns √|det| at an arc `distance` from the middle point; 0 if no position is found there.
double DoubleRootSearch::root_at(int block, double distance) {
  const std::optional<Point> p = curve_.step(last_[1].point, distance);
  const Determinants there = p ? determinants_.at(p->state) : Determinants{};
  return there.empty() ? 0 : std::exp(there.logs[block] / 2);
}

/// Returns the arc from the middle point at which a determinant is smallest, by Brent's method. Its
/// error is less than double_root_distance().
double DoubleRootSearch::least(int block) {
  const int bits = 3 - std::ilogb(curve_.limits().double_root_distance());
  const double end = last_[2].length;
  // Brent's method begins at `end`, to which a single step may not lead: the value is known.
  const auto root = [&](double distance) {
    return distance == end ? last_[2].root(block) : root_at(block, distance);
  };
  return boost::math::tools::brent_find_minima(root, -last_[1].length, end, bits).first;
}

/// Returns the driver's value at which ±√|det|, negative on one side, is zero; nothing if det is
/// not zero there. Both are interpolated from points around, since positions right next to a
/// singular one are not well known.
/// - about: arc of the root from the middle point, roughly
std::optional<double> DoubleRootSearch::value_of_root(int block, double about) {
  const double apart = curve_.limits().double_root_distance();
  std::vector<double> distances, roots, determinants, values;
  for (const int i : {-3, -2, -1, 1, 2, 3}) {
    const double distance = about + i * apart;
    const std::optional<Point> p = curve_.step(last_[1].point, distance);
    const Determinants there = p ? determinants_.at(p->state) : Determinants{};
    if (there.empty()) return {};
    if (there.signs[block] != last_[1].determinants.signs[block]) return {};  // another branch
    determinants.push_back(std::exp(there.logs[block]));
    roots.push_back(std::copysign(std::sqrt(determinants.back()), i));
    distances.push_back(distance);
    values.push_back(curve_.value(*p));
  }
  // det counts as zero if it is smaller than at a locking_arc from a double root.
  const double there = interpolated(roots, distances, 0),
               determinant = interpolated(distances, determinants, there),
               edge = determinants[2] + determinants[3],
               zero = curve_.limits().locking_arc() / apart;
  if (!(std::abs(there - about) < apart && std::abs(determinant) < edge * zero * zero)) return {};
  return interpolated(roots, values, 0);
}

}  // namespace desmo
