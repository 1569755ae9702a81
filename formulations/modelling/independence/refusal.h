#pragma once

#include <optional>
#include <vector>

#include "formulations/modelling/independence/row_selection.h"

namespace desmo {

/// A contradiction: equations of a group that cannot hold together once its drivers have moved.
struct Contradiction {
  int constraint;  ///< constraint with the largest residual at the least-squares position
  double amount;   ///< residual, relative to its length if it has one; else a number or [rad]
  double moved;    ///< displacement of the drivers, in natural magnitudes
  std::vector<int> others{};  ///< constraints that contradict it
};

/// Throws std::invalid_argument, naming group, bodies and the constraint with the largest |Φ|, with
/// its operands. phi: Φ of each row; where one is not finite, names the first constraint.
[[noreturn]] void refuse_assembly(const Model& model, const GroupSystem& system,
                                  const Eigen::VectorXd& phi);

/// Throws std::invalid_argument unless the selected rows determine the group and it can follow its
/// drivers. The message names group, bodies, drivers, and what can still move or how large the
/// contradiction is.
void require_determined(const Model& model, const GroupSystem& system, const SelectedRows& selected,
                        const std::optional<Contradiction>& contradiction);

}  // namespace desmo
