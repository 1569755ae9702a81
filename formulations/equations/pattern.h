#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// One partial derivative that a set of equations can emit.
struct JacobianEntry {
  int row;               ///< equation of the part, or -1: of another part
  int state;             ///< component of the state (q, then the fixed entities)
  bool resting = false;  ///< it never moves, unless it is an unknown
};

/// Where the partial derivatives of a part's n equations are kept: one array of `size()` values,
/// first Φ_φ (columns of the n unknowns) compressed by columns, then the entries of Φ_h (known
/// coordinates that move), then one value that nobody reads, for all that never moves.
struct Pattern {
  int n = 0;                         ///< unknowns and equations
  std::vector<int> unknowns;         ///< coordinate of each column, n
  std::vector<int> column_start;     ///< n + 1
  std::vector<int> row;              ///< of each entry of Φ_φ, ascending within a column
  std::vector<JacobianEntry> known;  ///< entries of Φ_h, by row

  int dependent_entries() const { return static_cast<int>(row.size()); }
  int size() const { return dependent_entries() + static_cast<int>(known.size()) + 1; }
};

/// A pattern, and for each entry it was made from the position of its value.
struct PatternWithSlots {
  Pattern pattern;
  std::vector<int> slots;
};

/// Lays out the entries that a part's equations emit. Done once; the timed loop only writes
/// values. Throws std::invalid_argument when two entries are the same partial derivative.
PatternWithSlots make_pattern(const Model& model, const PartDefinition& part,
                              std::span<const JacobianEntry> entries);

}  // namespace desmo
