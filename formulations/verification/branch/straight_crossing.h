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

/// The smooth continuation of a branch through a change point, as far as drivers go straight there.
///
/// On the point itself Φ_q is singular, and no path is proven to pass it. Which of the branches
/// beyond continues the one before is told by its derivatives with respect to the *arc* s of the
/// drivers. (Not by those with respect to time: where a driver rests, all branches are alike.) The
/// quintic through two instants before the point, at −2h and −h, is extended to one beyond, at h.
/// It misses the smooth continuation by an amount that falls 64-fold where h is halved; another
/// branch, whose m-th derivative jumps, 2ᵐ-fold. A fold has no instant beyond.
///
/// A straight line of drivers needs no instants of the motion: it leads as far before and beyond as
/// the mechanism moves, where the motion starts, ends, rests or turns back on the point. Both sides
/// of it are proven paths (BranchPath).
class StraightCrossing {
 public:
  /// Smallest factor by which the miss has to fall where h is halved: 2⁵, as where the fifth
  /// derivative jumps.
  static constexpr double min_fall = 32;

  /// Draws the line.
  /// - last: a proven instant, just before the point. s is 0 there
  /// - direction: rates of the drivers, of any length
  /// - group: that is singular on the point, as in DriverLine
  StraightCrossing(const Model& model, const CertifiedInstant& last,
                   std::span<const double> direction, GroupId group = no_position);
  StraightCrossing(const StraightCrossing&) = delete;
  StraightCrossing& operator=(const StraightCrossing&) = delete;

  /// Finds the smooth continuation. Returns whether there is one.
  bool find();

  /// Returns the least factor by which the miss falls, from one halving to the next until rounding
  /// hides it, or the first one where that is less than min_fall. Rounding of lengths counts as
  /// rounding: branches that meet but for it pass each other by, and the miss grows again towards
  /// the point. 0: nothing is proven or seen beyond. Overwrites reach(), positions() and width().
  /// - level: number of halvings before the first
  /// - beyond: positions at the distance h that belongs to the level, or near them
  double measure_fall(int level, std::span<const double> beyond);
  /// Returns the distance h of a level.
  double distance(int level) const;

  const DriverLine& line() const { return line_; }
  /// Return the distances from s = 0 at which the continuation begins to be proven, and up to which
  /// both sides are.
  double nearest() const { return nearest_; }
  double reach() const { return reach_; }

  /// Goes along the line, on the branch before the point (s < 0) or on the one beyond. Returns the
  /// instant there, whose rates are those with respect to s; null: it is not proven.
  const CertifiedInstant* go_to(double s);

  /// Returns a polynomial of each coordinate across the point, of s / width().
  const std::vector<Quintic<double>>& positions() const { return positions_; }
  double width() const { return width_; }

 private:
  /// A proven instant with the radii of all levels.
  struct Node {
    double s;
    PerLevel<std::vector<double>> values, radius;
  };

  /// Distance by which a continuation misses an instant beyond.
  struct Miss {
    std::vector<double> amount, rounding;  ///< of each coordinate
    bool is_hidden = true;                 ///< no coordinate's miss is more than rounding
    bool shows_jumps = true;  ///< those of fifth derivatives, of the coordinates' magnitudes, are

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

  std::vector<double> magnitudes_;  // of coordinates
  DriverLine line_;
  Model model_;  // with drivers that go along the line
  BranchPath before_, beyond_;
  Refinement refinement_;
  std::vector<double> no_rates_;
  std::vector<Node> nodes_;  // before the point, each half as far from s = 0 as the last
  std::array<std::vector<double>, 2> about_;  // positions at −reach_ and reach_
  std::vector<Quintic<double>> positions_;
  double nearest_ = 0, reach_ = 0, width_ = 0;
};

}  // namespace desmo
