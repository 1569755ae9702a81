#pragma once

#include <vector>

#include "formulations/base/modelling.h"
#include "formulations/modelling/bodies/rigid_bodies.h"
#include "formulations/modelling/groups/structure.h"

namespace desmo {

/// The place of a rigid body in the spanning tree.
struct TreeJoint {
  int parent = 0;               ///< rigid body that it hangs on; 0: the ground
  int joint = Mechanism::none;  ///< joint of the mechanism; none: a free joint
  bool is_first = false;        ///< the body is the first of the joint
};

/// A spanning tree of the rigid bodies that have a frame. In `relative` coordinates a body hangs on
/// its parent by a joint of the mechanism. Where none is suitable, it hangs on the ground by a free
/// joint. In `reference` coordinates all bodies do.
struct SpanningTree {
  std::vector<int> order;  ///< all rigid bodies but the ground: parents first, group by group
  std::vector<TreeJoint> hanging;  ///< tree joint of each rigid body
  std::vector<bool> has_frame;     ///< whether each rigid body has a frame; true for the ground
  std::vector<bool> is_of_tree;    ///< whether each joint is in the tree; all others are cut
};

/// Returns the tree. Groups come in solution order. Within a group, the next body hangs on a placed
/// body by the joint with the fewest variables. Among equals the body with the most joints goes
/// first. Then the parent nearest to earlier groups decides, then the order of the joints.
/// Bodies without such a joint hang on the ground by a free joint. A body that can spin idly, such
/// as a rod between two spherical joints, has no frame.
SpanningTree make_tree(const Mechanism& mechanism, const RigidBodies& rigid,
                       const Structure& structure, Modelling modelling);

/// Returns, for each list of rigid bodies, the one that comes first in the tree; the ground comes
/// before all others. Returns no_position for an empty list.
std::vector<int> first_carriers(const std::vector<std::vector<int>>& carriers,
                                const SpanningTree& tree);

}  // namespace desmo
