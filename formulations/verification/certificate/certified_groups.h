#pragma once

#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/verification/certificate/certified_block.h"
#include "formulations/verification/certificate/error_basis.h"

namespace desmo {

/// Coordinates of a group that a later group of a long chain reads.
struct GroupInterface {
  std::vector<int> coordinates, rows;  ///< rows in the earlier group's ErrorRows
  ErrorBasis basis;                    ///< errors of all coordinates, one level after the other
  PerLevel<std::vector<double>> center;
  bool enclosed = false;  ///< by the basis, at this instant; otherwise only by radii
};

/// A structural group with its irreducible blocks in solution order.
struct CertifiedGroup {
  /// Rows of what the group reads, of an interface or of a single coordinate.
  struct Source {
    int interface, coordinate;  ///< one of them is -1
    int row;                    ///< the first one
    int symbol;                 ///< number of symbols before its own, at each level
  };

  GroupId id;
  std::vector<Source> sources;
  std::vector<CertifiedBlock> blocks;
  std::vector<int> interfaces;  ///< those that later groups read of this one
  int symbols = 0;              ///< at each level
};

/// The groups of a model in solution order, and what ErrorRows need room for.
struct CertifiedGroups {
  std::vector<CertifiedGroup> groups;
  std::vector<GroupInterface> interfaces;
  int max_rows = 0, max_generators = 0;
};

/// Cuts a model into groups and blocks. Errors go from group to group as boxes, but along chains of
/// many groups in bases: there boxes would grow without limit.
CertifiedGroups certified_groups(const Model& model);

}  // namespace desmo
