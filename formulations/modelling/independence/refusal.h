#pragma once

#include <optional>

#include "formulations/modelling/independence/contradiction.h"
#include "formulations/modelling/independence/row_selection.h"

namespace desmo {

/// Throws std::invalid_argument, naming group, bodies and the constraint that Φ says is satisfied
/// worst.
[[noreturn]] void refuse_assembly(const Model& model, const GroupSystem& system,
                                  const Eigen::VectorXd& phi);

/// Throws std::invalid_argument, naming group, bodies, drivers and what can still move, or by how
/// much the equations contradict each other, unless the selected rows determine the group and it
/// can follow its drivers.
void require_determined(const Model& model, const GroupSystem& system, const SelectedRows& selected,
                        const std::optional<Contradiction>& contradiction);

}  // namespace desmo
