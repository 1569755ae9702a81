#pragma once

#include <Eigen/Core>
#include <array>
#include <tuple>
#include <vector>

#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/independence/linearisation.h"

namespace desmo {

/// The states at which the dependence of equations is judged: the nominal position, then two
/// perturbed ones.
using JudgedPositions = std::array<std::vector<double>, 3>;

/// Assembles these positions. Each group may move its unknowns and its drivers. A perturbed
/// position that cannot be assembled is replaced by the nominal one. Throws std::invalid_argument,
/// naming group, bodies and constraint, when the nominal position cannot be assembled.
JudgedPositions assemble_positions(const Model& model, const std::vector<GroupSystem>& systems,
                                   Lineariser& lineariser);

/// The independent equations of a group.
struct SelectedRows {
  std::vector<bool> taken;  ///< whether each row of the system is selected
  /// Scaled Jacobians of all rows (rows × columns), at each judged position.
  std::array<Eigen::MatrixXd, std::tuple_size_v<JudgedPositions>> jacobians;
};

/// A selector of independent equations among a group's candidates; see leave_out_dependent.
class RowSelector {
 public:
  /// Stores references: all arguments must outlive the selector.
  RowSelector(Candidates& candidates, const JudgedPositions& positions, Lineariser& lineariser);

  SelectedRows select(const GroupSystem& system);

  /// Replaces definitions with one selected equation by their ScalarDefinition, in the candidates,
  /// the system and the selection. The sine or the cosine of an angle alone would be singular at
  /// some positions.
  void shorten(GroupSystem& system, SelectedRows& selected);

 private:
  std::vector<int> preference(const GroupSystem& system) const;
  bool shorten_definitions(const GroupSystem& system, const std::vector<bool>& taken);

  Model& m_;
  const std::vector<Origin>& origins_;  // source of each constraint
  const JudgedPositions& positions_;
  Lineariser& lineariser_;
  std::vector<bool> moves_;  // whether each component of the state moves
};

}  // namespace desmo
