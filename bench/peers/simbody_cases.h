#pragma once

#include <vector>

#include "bench/peers/simbody_solver.h"
#include "cases/mechanism/scene.h"
#include "formulations/model/model.h"

namespace desmo::simbody {

/// A case as Simbody takes it, and what of the mechanism the tree tells.
struct CaseTree {
  Tree tree;
  std::vector<int> coordinates;  ///< of the mechanism: those of tree.followed, in its order
};

/// The scene's mechanism as a tree. It must be one of the suite's cases, or
/// std::invalid_argument is thrown. The scene must outlive the tree.
CaseTree case_tree(const Scene& scene, const Model& model);

}  // namespace desmo::simbody
