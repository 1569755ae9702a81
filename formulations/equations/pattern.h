#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Partial derivative that a set of equations can emit.
struct JacobianEntry {
  int row;               ///< equation of the part; -1: the equation is of another part
  int place;             ///< component of the state (q, then the fixed entities)
  bool resting = false;  ///< true: the component never moves; ignored where it is an unknown
};

/// Positions of the partial derivatives of a part's n equations in one array of `size()` values.
/// First stands Φ_φ (by the n unknowns), compressed by columns; then Φ_h (by known coordinates that
/// move). The last value is never read. Derivatives by what never moves, and those of equations of
/// other parts, are all written there.
struct Pattern {
  int n = 0;                         ///< number of unknowns and equations
  std::vector<int> unknowns;         ///< coordinate of each column (n)
  std::vector<int> column_start;     ///< first entry of each column, and the end (n + 1)
  std::vector<int> row;              ///< equation of each entry of Φ_φ, ascending within a column
  std::vector<JacobianEntry> known;  ///< entries of Φ_h, ordered by row

  int dependent_entries() const { return static_cast<int>(row.size()); }
  int size() const { return dependent_entries() + static_cast<int>(known.size()) + 1; }
};

/// A pattern. slots: for each entry, in the order in which equations emit them, the position of its
/// value in the pattern.
struct PatternWithSlots {
  Pattern pattern;
  std::vector<int> slots;
};

/// Lays out the entries that a part's equations emit, once; the timed loop only writes values.
/// Throws std::invalid_argument when two entries are the same partial derivative.
PatternWithSlots make_pattern(const Model& model, const PartDefinition& part,
                              std::span<const JacobianEntry> entries);

}  // namespace desmo
