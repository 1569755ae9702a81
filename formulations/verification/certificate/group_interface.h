#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/error_basis.h"
#include "formulations/verification/certificate/error_table.h"

namespace desmo {

/// Coordinates of a group that a later group of a long chain reads. Their errors go from one group
/// to the other in a basis.
struct GroupInterface {
  std::vector<int> coordinates, rows;  ///< rows in ErrorTable, while its group is certified
  ErrorBasis basis;                    ///< errors of all coordinates, one level after the other
  PerLevel<std::vector<double>> centre;
  bool enclosed = false;  ///< by the basis, at this instant; otherwise only by radii

  int size() const { return static_cast<int>(coordinates.size()); }
  /// Encloses the errors of its rows at these levels. Without levels, or where an error is not
  /// bounded, lend() hands on radii.
  void enclose(std::span<const Level> solved, const PerLevel<ErrorTable>& errors);
  /// Writes the errors at a level to lent rows from `row` on, whose symbols begin at this column.
  void lend(Level level, int row, int column, ErrorTable& to) const;
};

}  // namespace desmo
