#pragma once

#include <utility>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// One group's candidate equations as rows, its unknowns and then its drivers as columns.
struct GroupSystem {
  GroupId group;
  int first_constraint = 0, end_constraint = 0;
  std::vector<int> columns;  ///< coordinates: the unknowns, then the drivers
  int unknowns = 0;
  std::vector<std::pair<int, int>> rows;  ///< constraint and its row

  int drivers() const { return static_cast<int>(columns.size()) - unknowns; }
};

/// Those of all groups, in group order.
std::vector<GroupSystem> group_systems(const Model& model);

/// Lists the rows anew, after constraints of the group have changed.
void list_rows(const Model& model, GroupSystem& system);

}  // namespace desmo
