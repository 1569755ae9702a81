#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/error_basis.h"
#include "formulations/verification/certificate/error_table.h"

namespace desmo {

/// Coordinates of a group of a long chain that a later group reads. A basis hands their errors on.
struct GroupInterface {
  std::vector<int> coordinates;
  std::vector<int> rows;  ///< row of each coordinate in ErrorTable while its group is certified
  ErrorBasis basis;       ///< errors of all coordinates, one level after the other
  PerLevel<std::vector<double>> centre;  ///< centres of these errors
  /// Basis and centres hold the errors of this instant. If not, lend() hands on boxes.
  bool enclosed = false;

  int size() const { return static_cast<int>(coordinates.size()); }
  /// Encloses the errors of `rows` at these levels in the basis. Without levels, or if an error is
  /// not bounded, lend() then hands on the boxes of the coordinates.
  void enclose(std::span<const Level> solved, const PerLevel<ErrorTable>& errors);
  /// Writes the errors at a level to the lent rows from `row` on. Their symbols begin at `column`.
  void lend(Level level, int row, int column, ErrorTable& to) const;
};

}  // namespace desmo
