#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "cases/numbers/interval.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/driver_line.h"
#include "formulations/verification/certificate/hermite.h"

namespace desmo {

/// The smooth continuation of a branch through a change point, along a straight line of drivers.
///
/// On the point itself Φ_q is singular, and no path is proven to pass it. Derivatives with respect
/// to the *arc* s of the drivers tell which of the branches beyond continues the one before. (Those
/// with respect to time do not: where a driver rests, all branches are alike.) The quintic through
/// two instants before the point, at s = −2h and −h, is extended to h. Its distance from a solution
/// there is the *miss*. Where h is halved, it falls 64-fold on the smooth continuation, and 2ᵐ-fold
/// on another branch, whose m-th derivative jumps. A fold has no instant beyond.
///
/// The line needs no instants of the motion, which may start, end, rest or turn back on the point.
/// It leads as far before and beyond as the mechanism moves. Both sides of it are proven paths
/// (BranchPath). All paths share one budget of tests. Where the line leads to infinity, or past
/// many places that are hard to prove, the search thus ends without a continuation.
class SingularityCrossing {
 public:
  /// A continuation counts as smooth if the miss falls at least by this factor where h is halved:
  /// 2⁵, as where the fifth derivative jumps.
  static constexpr double min_fall = 32;

  /// Draws the line.
  /// - last: a proven instant just before the point; s is 0 there
  /// - direction: rates of the drivers, of any length
  /// - group: the group that is singular on the point (see DriverLine)
  /// - budget: of the tests of all calls, which callers may share. It must outlive this object
  SingularityCrossing(const Model& model, const CertifiedInstant& last,
                      std::span<const double> direction, GroupId group, TestBudget& budget);
  SingularityCrossing(const SingularityCrossing&) = delete;
  SingularityCrossing& operator=(const SingularityCrossing&) = delete;

  /// Finds the smooth continuation, and sets nearest(), reach(), positions() and width(). Returns
  /// whether one is found; false also where proofs fail or rounding hides which branch is smooth.
  bool find();

  /// Returns the least factor by which the miss falls from one halving to the next, until rounding
  /// hides it. If the first factor is less than min_fall, returns that one; 0 if nothing is proven
  /// or seen beyond. Rounded lengths may turn branches that meet into branches that pass each other
  /// closely. The miss then grows again towards the point, which counts as rounding. Overwrites
  /// reach(), positions() and width().
  /// - level: number of halvings before the first h, distance(level)
  /// - beyond: positions at the distance h, or near them
  double measure_fall(int level, std::span<const double> beyond);
  /// Returns the distance h of a level.
  double distance(int level) const;

  const DriverLine& line() const { return line_; }
  /// Returns the smallest s > 0 at which the continuation beyond the point is proven.
  double nearest() const { return nearest_; }
  /// Returns the distance from s = 0 up to which both sides are proven.
  double reach() const { return reach_; }

  /// Goes along the line to s, on the branch before the point (s < 0) or on the one beyond. Returns
  /// the instant there, with rates with respect to s; null: it is not proven.
  const CertifiedInstant* go_to(double s);

  /// Returns a polynomial of each coordinate across the point, with argument s / width().
  const std::vector<Quintic<double>>& positions() const { return positions_; }
  double width() const { return width_; }

 private:
  /// A proven instant with the radii of all levels.
  struct Node {
    double s;
    PerLevel<std::vector<double>> values, radius;
  };

  /// Distance by which an extended quintic misses an instant beyond.
  struct Miss {
    std::vector<double> amount, rounding;  ///< of each coordinate
    bool is_hidden = true;                 ///< by rounding, in each coordinate
    /// A jump of a fifth derivative as large as the coordinate's magnitude would be seen: rounding
    /// < magnitude × s⁵ of each coordinate.
    bool shows_jumps = true;

    double over(const std::vector<double>& unit) const;
  };

  static Interval number(const Node& node, Level level, int coordinate);

  void find_nodes(const CertifiedInstant& last);
  Miss miss(int level, const Node& beyond) const;
  void join(const Node& before, const Node& beyond);
  bool leads_to(const Node& end, double nearest);
  std::optional<Node> node(const CertifiedInstant& instant);
  bool reach_nodes(int count);
  Quintic<Interval> polynomial(const Node& a, const Node& b, int coordinate) const;

  TestBudget& budget_;
  std::vector<double> magnitudes_;  // of coordinates
  DriverLine line_;
  Model model_;  // with drivers that go along the line
  BranchPath before_, beyond_;
  Refinement refinement_;
  std::vector<Node> nodes_;  // before the point, each half as far from s = 0 as the one before
  std::array<std::vector<double>, 2> about_;  // positions at −reach_ and reach_
  std::vector<Quintic<double>> positions_;
  double nearest_ = 0, reach_ = 0, width_ = 0;
};

}  // namespace desmo
