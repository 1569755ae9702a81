#pragma once

#include <Eigen/Core>
#include <utility>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// A row of length 1 depends on others when its component orthogonal to them has a length ≤ this.
inline constexpr double dependent_below = 1e-6;
/// The same limit for a group that closes only to the digits of its file. It is also the largest
/// misfit of such a group, relative to its lengths; groups that are off by more are refused.
inline constexpr double max_misfit = 1e-4;
/// A row whose derivatives are uncertain also depends on others when that length is ≤ this times
/// the relative uncertainty.
inline constexpr double uncertainty_margin = 10;

/// The system of a group: its candidate equations, without those between constants, are rows; its
/// unknowns, then drivers, are columns.
struct GroupSystem {
  GroupId group;
  int first_constraint = 0, end_constraint = 0;  ///< range of its candidates in the model
  std::vector<int> columns;                      ///< position in q of each column
  int unknowns = 0;                              ///< number of columns that are unknowns
  std::vector<std::pair<int, int>> rows;         ///< constraint, and row in it, of each row
  bool redundant = false;                        ///< the group has more restrictions than freedoms
  double dependent_below = desmo::dependent_below;  ///< max_misfit where a group needs it

  /// Returns whether the group closes only to the digits of its file.
  bool closes_nearly() const { return dependent_below == max_misfit; }
  int drivers() const { return static_cast<int>(columns.size()) - unknowns; }
};

/// Returns the systems of all groups, in group order.
std::vector<GroupSystem> group_systems(const Model& model);

/// Updates system.rows after constraints of the group have changed.
void list_rows(const Model& model, GroupSystem& system);

/// Scaled Φ and Φ_q of a group's candidates. Columns are multiplied by natural magnitudes: for
/// points and distances the largest power of two that is ≤ their characteristic length, else 1.
/// Rows are divided by the norm of these entries. Where 1e-8 of the norm of their derivatives by
/// all other variables is larger, they are divided by that. A change of units changes scales by
/// factors below two.
struct Linearisation {
  Eigen::VectorXd phi;       ///< scaled Φ (rows of the GroupSystem)
  Eigen::MatrixXd jacobian;  ///< scaled Φ_q (rows × columns of the GroupSystem)
  Eigen::VectorXd share;     ///< divisor of each row, relative to its norm for all variables (rows)
  Eigen::VectorXd rounding;  ///< largest |Φ| by rounding of the variables that a row reads (rows)

  /// Returns |Φ| relative to the norms of rows for all variables, less what rounding may cause. So
  /// equations that hold do not count, however far from the origin their points are.
  Eigen::VectorXd relative_phi() const {
    return (phi.cwiseAbs() - rounding).cwiseMax(0).cwiseProduct(share);
  }
};

/// A lineariser of the group systems of a model.
class Lineariser {
 public:
  /// The lengths by which points and distances are scaled: the longest or the shortest of the
  /// bodies around them (CharacteristicLengths). With the shortest, small bodies on large ones
  /// count as much as these.
  enum class Lengths { longest, shortest };

  /// Finds the natural magnitudes. The model must outlive the object; its constraints may change.
  explicit Lineariser(const Model& model, Lengths lengths = Lengths::longest);

  /// Evaluates the linearisation of a group at a state (q, then the fixed values).
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
  /// uncertain: largest error of its derivatives, relative to the largest derivative.
  bool add(Eigen::VectorXd row, double uncertain = 0);
  int rank() const { return rank_; }

 private:
  Eigen::MatrixXd basis_;
  double dependent_below_;
  int rank_ = 0;
};

/// Returns the minimum-norm least-squares solution x of J x = φ. Equations may depend on each
/// other. phi: one φ or several, as columns.
Eigen::MatrixXd smallest_correction(const GroupSystem& system, const Eigen::MatrixXd& jacobian,
                                    const Eigen::MatrixXd& phi);

}  // namespace desmo
