#pragma once

#include <string_view>
#include <vector>

#include "formulations/formulation.h"

namespace desmo {

/// Parts that one library solves.
struct PartSolver {
  std::string_view algebra;  ///< name of the backend
  int parts = 0;
  int least_unknowns = 0, most_unknowns = 0;  ///< of one of them
};

/// Which libraries solve the parts of a formulation, constant ones left out: the one with the
/// largest parts first.
std::vector<PartSolver> part_solvers(const Formulation& formulation);

}  // namespace desmo
