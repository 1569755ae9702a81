#pragma once

#include <Eigen/Core>
#include <array>
#include <tuple>
#include <vector>

#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/independence/judged_positions.h"

namespace desmo {

/// Which rows of a group's system are its independent equations.
struct SelectedRows {
  std::vector<bool> taken;  ///< each row
  /// Of all rows, at each of the judged positions.
  std::array<Eigen::MatrixXd, std::tuple_size_v<JudgedPositions>> jacobians;
};

/// Selects the equations of the groups among their candidates; see leave_out_dependent.
class RowSelector {
 public:
  /// All must outlive it.
  RowSelector(Candidates& candidates, const JudgedPositions& positions, Lineariser& lineariser);

  SelectedRows select(const GroupSystem& system);

  /// Replaces each definition of which one equation is selected, in the candidates, the system and
  /// the selection, by the one equation that says the same: of the sine and the cosine of an angle,
  /// either is singular somewhere.
  void shorten(GroupSystem& system, SelectedRows& selected);

 private:
  std::vector<int> preference(const GroupSystem& system) const;
  bool shorten_definitions(const GroupSystem& system, const std::vector<bool>& taken);

  Model& m_;
  const std::vector<Origin>& origins_;  // of its constraints
  const JudgedPositions& positions_;
  Lineariser& lineariser_;
  std::vector<bool> moves_;  // each component of the state
};

}  // namespace desmo
