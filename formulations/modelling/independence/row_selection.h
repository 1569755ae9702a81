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

/// The linearisers of a model: by the longest lengths and, where these hide small bodies on large
/// ones, by the shortest.
struct Linearisers {
  explicit Linearisers(const Model& model)
      : usual(model), of_small(model, Lineariser::Lengths::shortest) {}
  Lineariser usual, of_small;
};

/// Assembles these positions. Each group may move its unknowns and its drivers. A perturbed
/// position that cannot be assembled is replaced by the nominal one. Where a redundant group cannot
/// be assembled, or not move with its drivers, but for max_misfit, sets what its equations depend
/// below. Throws std::invalid_argument, naming group, bodies and constraint, when the nominal
/// position cannot be assembled.
JudgedPositions assemble_positions(const Model& model, std::vector<GroupSystem>& systems,
                                   Linearisers& linearisers);

/// Scaled Jacobians of all rows (rows × columns), at each judged position.
using JudgedJacobians = std::array<Eigen::MatrixXd, std::tuple_size_v<JudgedPositions>>;

/// Returns the freedoms that the candidates leave to a group, drivers free, at the most general
/// position.
int mobility(const GroupSystem& system, const JudgedJacobians& jacobians);

/// The independent equations of a group.
struct SelectedRows {
  std::vector<bool> taken;  ///< whether each row of the system is selected
  /// Largest relative uncertainty of a row's derivatives by rounding of positions, with the
  /// shortest lengths; found where too few rows are selected.
  double uncertain = 0;
  JudgedJacobians jacobians;
};

/// A selector of independent equations among a group's candidates; see leave_out_dependent.
class RowSelector {
 public:
  /// Stores references: all arguments must outlive the selector.
  RowSelector(CandidateEquations& candidates, const JudgedPositions& positions,
              Linearisers& linearisers);

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
  Linearisers& linearisers_;
  std::vector<bool> moves_;  // whether each component of the state moves
};

}  // namespace desmo
