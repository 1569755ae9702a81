#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// A search for double roots of the determinants of irreducible blocks, point by point along a
/// curve: for singular positions at which none changes its sign. There the square root of a
/// determinant changes its sign like a line: of three points in a row the middle one tells whether
/// it may. An evaluation costs a step.
class DoubleRootSearch {
 public:
  /// Both must outlive the search.
  DoubleRootSearch(SolutionCurve& curve, const BlockDeterminants& determinants)
      : curve_(curve), determinants_(determinants) {}

  void restart() {
    last_.clear();
    since_ = 0;
  }

  /// Adds the point that lies a length after the last one, and its determinants, none of which is
  /// zero or has changed its sign since then. Returns the first double root around the last point,
  /// to 1e-9 rad or characteristic lengths.
  std::optional<ChangePoint> add(const SolutionCurve::Point& point, const Determinants& there,
                                 double length);

 private:
  struct Sample {
    SolutionCurve::Point point;
    double length;  // since the one before
    Determinants determinants;

    double root(int block) const { return std::exp(determinants.logs[block] / 2); }  // √|det|
  };

  bool may_have_root(int block) const;
  double root_at(int block, double distance);
  double least(int block);
  std::optional<double> value_of_root(int block, double about);

  SolutionCurve& curve_;
  const BlockDeterminants& determinants_;
  std::vector<Sample> last_;  // three at most
  double since_ = 0;          // length since the last of them
};

}  // namespace desmo
