#pragma once

#include <utility>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// The system of a group: its candidate equations are rows; its unknowns, then drivers, are
/// columns.
struct GroupSystem {
  GroupId group;
  int first_constraint = 0, end_constraint = 0;
  std::vector<int> columns;               ///< coordinates
  int unknowns = 0;                       ///< number of columns that are unknowns
  std::vector<std::pair<int, int>> rows;  ///< constraint and its row

  int drivers() const { return static_cast<int>(columns.size()) - unknowns; }
};

/// Returns the systems of all groups, in group order.
std::vector<GroupSystem> group_systems(const Model& model);

/// Updates system.rows after constraints of the group have changed.
void list_rows(const Model& model, GroupSystem& system);

}  // namespace desmo
