#pragma once

#include <Eigen/SparseLU>
#include <optional>
#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"
#include "formulations/verification/range/range_limits.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

/// Curve of the positions that a mechanism can take while one driver moves and the others rest:
/// Φ(φ, z) = 0, with the unknowns φ that depend on the driver, and the driver's value z. It is
/// followed by its arc (Keller 1977): a predictor goes along the tangent t, and Newton's method
/// corrects in the plane across it. Its matrix
///
///   B = [Φ_φ  Φ_z]
///       [   tᵀ   ]
///
/// has columns multiplied by characteristic lengths (1 rad for angles). The rows of Φ are then
/// divided by the sums of their magnitudes. B is regular at dead points, where Φ_φ is singular and
/// the driver turns back.
class SolutionCurve {
 public:
  /// A position on the curve.
  struct Point {
    std::vector<double> state;  ///< q, then the fixed components
    /// Components over scale(), of the unknowns and then the driver; the largest is 1 or −1.
    Eigen::VectorXd tangent;
    int sign = 0;                ///< of det B; changes where curves cross
    double log_determinant = 0;  ///< log |det B|, with rows not divided by their sums

    /// Returns the driver's component of the tangent: 0 at a dead point.
    double speed() const { return tangent[tangent.size() - 1]; }
  };

  /// driver: position in Model::drivers. The model must outlive the curve.
  SolutionCurve(const Model& model, int driver, const RangeLimits& limits);

  /// Returns whether no unknown depends on the driver.
  bool is_idle() const { return unknowns_.empty(); }

  /// Returns the point of the curve at or next to a position that is nearly solved; nothing if none
  /// is found. It has the driver's value of the position unless a dead point is near. The driver
  /// moves upwards along the tangent. At a crossing the position is not corrected.
  std::optional<Point> start(std::vector<double> state);
  /// Returns whether the last start() was at a crossing of two curves, to rounding.
  bool is_crossing() const { return crosses_; }

  /// Returns the point a step further along the curve: the largest scaled change of a component is
  /// about `length`, which may be negative. Returns nothing if Newton's method does not converge at
  /// once, or the tangent turns too far.
  std::optional<Point> step(const Point& from, double length);

  /// Returns the point at which the driver has a value, starting from a point nearby.
  std::optional<Point> at(const Point& from, double value);

  /// Returns the same point with its tangent reversed: step() then leaves it in the other
  /// direction.
  static Point reversed(Point point);

  /// Magnitudes of the Lagrange multipliers that hold a force on the driver. Rows of Φ_q are
  /// divided by the sums of their magnitudes.
  struct Forces {
    /// Largest multiplier of each constraint, divided by the largest of all.
    std::vector<double> of_constraints;
    double rounding;  ///< change of the driver's value that rounding of Φ may cause
  };
  /// Returns the forces at a point. At a dead point they tell what stops the driver. If B is
  /// singular, forces are 0 and `rounding` is infinite.
  Forces forces(const Point& point);

  const RangeLimits& limits() const { return limits_; }
  double value(const Point& point) const { return point.state[driver_]; }
  double scale() const { return scale_.back(); }  ///< of the driver: 1 rad or a length
  const std::vector<int>& unknowns() const { return unknowns_; }  ///< coordinates, ascending
  double scale(int unknown) const { return scale_[unknown]; }
  /// Irreducible blocks that depend on the driver, in solution order.
  const std::vector<PartDefinition>& blocks() const { return blocks_; }

 private:
  int size() const { return static_cast<int>(unknowns_.size()); }
  /// Returns the direction in which the driver alone moves.
  Eigen::VectorXd along_driver() const { return Eigen::VectorXd::Unit(size() + 1, size()); }
  void move(std::vector<double>& state, double factor, const Eigen::VectorXd& change) const;
  bool factor(std::span<const double> state, const Eigen::VectorXd& border);
  bool correct(std::vector<double>& state, const Eigen::VectorXd& border, double max_first);
  std::optional<Point> settle(std::vector<double> state, const Eigen::VectorXd& along);

  const RangeLimits limits_;
  WholeSystem system_;
  int driver_;  // the driver's component of the state
  std::vector<int> unknowns_;
  std::vector<double> scale_;  // of the unknowns, then of the driver
  std::vector<PartDefinition> blocks_;
  std::vector<int> column_;      // column in B of each component of the state; -1: at rest
  std::vector<int> row_;         // row in B of each row of the whole system; -1: no unknown in it
  std::vector<int> constraint_;  // constraint of each row in B
  std::size_t constraints_;
  Eigen::VectorXd row_sums_;
  std::vector<double> phi_;
  std::vector<Eigen::Triplet<double>> entries_;  // of B
  Eigen::SparseMatrix<double> matrix_;           // B
  Eigen::SparseLU<Eigen::SparseMatrix<double>> lu_;
  bool is_analysed_ = false;
  bool crosses_ = false;
};

}  // namespace desmo
