#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// A row of length 1 depends on others when its component orthogonal to them is not longer than
/// this.
inline constexpr double dependent_below = 1e-6;
/// The same in a group that closes only to the digits of its file. These may leave a misfit of as
/// much, over its lengths; what closes less is refused.
inline constexpr double max_misfit = 1e-4;
/// A row whose derivatives are uncertain depends on others below this times the uncertainty.
inline constexpr double uncertainty_margin = 10;

/// The system of a group: its candidate equations, without those between constants, are rows; its
/// unknowns, then drivers, are columns.
struct GroupSystem {
  GroupId group;
  int first_constraint = 0, end_constraint = 0;
  std::vector<int> columns;               ///< coordinates
  int unknowns = 0;                       ///< number of columns that are unknowns
  std::vector<std::pair<int, int>> rows;  ///< constraint and its row
  bool redundant = false;                 ///< the group has more restrictions than freedoms
  double dependent_below = desmo::dependent_below;

  bool closes_nearly() const { return dependent_below == max_misfit; }
  int drivers() const { return static_cast<int>(columns.size()) - unknowns; }
};

/// Returns the systems of all groups, in group order.
std::vector<GroupSystem> group_systems(const Model& model);

/// Updates system.rows after constraints of the group have changed.
void list_rows(const Model& model, GroupSystem& system);

/// Scaled Φ and Φ_q of a group's candidates. Columns are multiplied by natural magnitudes: for
/// points and distances the power of two next to their characteristic length, else 1. Rows are
/// divided by their norm over the columns of the group, in its own lengths; what comes before it
/// counts as uncertain by 1e-8. The result does not depend on units.
struct Linearisation {
  Eigen::VectorXd phi;       ///< (rows)
  Eigen::MatrixXd jacobian;  ///< (rows × columns) of the GroupSystem
  Eigen::VectorXd share;     ///< of a row's norm in that over all variables it reads (rows)
  Eigen::VectorXd rounding;  ///< what rounding of all that a row reads may make of Φ (rows)

  /// Returns |Φ| over all that it reads, without what rounding may make of it: however far points
  /// are, nothing is left of equations that hold.
  Eigen::VectorXd relative_phi() const {
    return (phi.cwiseAbs() - rounding).cwiseMax(0).cwiseProduct(share);
  }
};

/// A lineariser of the group systems of a model.
class Lineariser {
 public:
  /// Lengths by which points and distances are measured: of the bodies around them
  /// (CharacteristicLengths), the longest or the shortest. By the shortest a small body that large
  /// ones carry is not lost.
  enum class Lengths { longest, shortest };

  /// Finds the natural magnitudes. The model must outlive the object; its constraints may change.
  explicit Lineariser(const Model& model, Lengths lengths = Lengths::longest);

  Linearisation at(const std::vector<double>& state, const GroupSystem& system);

  /// Adds a step, given in natural magnitudes of the system's columns, to the state.
  void move(std::vector<double>& state, const GroupSystem& system,
            const Eigen::VectorXd& step) const;

 private:
  const Model& m_;
  std::vector<double> scale_;  // natural magnitude of each component of the state
  std::vector<int> column_;    // column of each component in the current system, or -1
};

/// The span of independent rows, added one by one.
class RowSpace {
 public:
  explicit RowSpace(const GroupSystem& system, int columns)
      : basis_(columns, columns), dependent_below_(system.dependent_below) {}

  /// Adds a row of length ≤ 1 if it is independent of the rows before. Returns whether it was.
  /// uncertain: by how much its derivatives may be off, relative to the largest.
  bool add(Eigen::VectorXd row, double uncertain = 0);
  int rank() const { return rank_; }

 private:
  Eigen::MatrixXd basis_;
  double dependent_below_;
  int rank_ = 0;
};

/// Returns the minimum-norm least-squares solution x of J x = φ, which also serves dependent
/// equations. phi: one φ or several, side by side.
Eigen::MatrixXd smallest_correction(const GroupSystem& system, const Eigen::MatrixXd& jacobian,
                                    const Eigen::MatrixXd& phi);

}  // namespace desmo
