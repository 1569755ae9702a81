#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Double root of a determinant: a singular position at which it does not change its sign.
struct DoubleRoot {
  double value;  ///< the driver's
  GroupId group;
};

/// A search for double roots of the determinants of irreducible blocks, point by point along a
/// curve. There the square root of a determinant changes its sign like a line: of three points in a
/// row the middle one tells whether it may. An evaluation costs a step.
class DoubleRootSearch {
 public:
  /// Both must outlive the search.
  DoubleRootSearch(SolutionCurve& curve, BlockDeterminants& determinants)
      : curve_(curve), determinants_(determinants) {}

  void restart() {
    last_.clear();
    since_ = 0;
  }

  /// Adds the point that lies a length after the last one, where the caller has evaluated the
  /// determinants; they are elsewhere afterwards. No determinant has changed its sign since the
  /// last point. Returns the first double root around that, to 1e-9 rad or characteristic lengths.
  std::optional<DoubleRoot> add(const SolutionCurve::Point& point, double length);

 private:
  struct Sample {
    SolutionCurve::Point point;
    double length;              // since the one before
    std::vector<double> roots;  // √|det| of every block
    std::vector<signed char> signs;
  };

  bool may_have_root(int block) const;
  double root_at(int block, double distance);
  double least(int block);
  std::optional<double> value_of_root(int block, double about);

  SolutionCurve& curve_;
  BlockDeterminants& determinants_;
  std::vector<Sample> last_;  // three at most
  double since_ = 0;          // length since the last of them
};

}  // namespace desmo
