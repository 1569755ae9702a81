#pragma once

#include <cmath>
#include <optional>
#include <vector>

#include "formulations/verification/range/block_determinants.h"
#include "formulations/verification/range/driver_range.h"
#include "formulations/verification/range/solution_curve.h"

namespace desmo {

/// Search for singular positions along a curve, point by point, at which no determinant of an
/// irreducible block changes its sign: double roots. Near one, √|det| with its sign changed on one
/// side is about linear in the arc. So the middle one of three successive points tells whether
/// there may be a root. Each evaluation of the search costs a step of the curve.
class DoubleRootSearch {
 public:
  /// Both must outlive the search.
  DoubleRootSearch(SolutionCurve& curve, const BlockDeterminants& determinants)
      : curve_(curve), determinants_(determinants) {}

  void restart() {
    last_.clear();
    since_ = 0;
  }

  /// Adds a point that lies an arc `length` after the last one, with its determinants. None of them
  /// is zero or has changed its sign since then. Returns a double root near the point that
  /// was added before: that of the first block which has one. The driver's value is exact to 1e-9
  /// rad or characteristic lengths.
  std::optional<ChangePoint> add(const SolutionCurve::Point& point, const Determinants& there,
                                 double length);

 private:
  struct Sample {
    SolutionCurve::Point point;
    double length;  // arc from the sample before
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
  double since_ = 0;          // arc since the last of them
};

}  // namespace desmo
