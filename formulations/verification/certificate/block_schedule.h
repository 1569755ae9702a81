#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/group_interface.h"

namespace desmo {

/// A structural group that takes or hands on errors in bases. It lies in a long chain, or reads
/// from a group that does. A chain is a sequence of groups, each of which reads from the one
/// before.
struct ChainLink {
  /// An interface of an earlier group that this group reads. Its errors stand in lent rows of
  /// ErrorTable. Errors of all other inputs are boxes.
  struct Source {
    int interface;  ///< position in BlockSchedule::interfaces
    int row;        ///< first lent row
    int symbol;     ///< number of symbols of the sources before this one, per level
  };
  std::vector<Source> sources;
  std::vector<int> interfaces;  ///< positions of this group's interfaces that later groups read
  int symbols = 0;              ///< symbols of all sources, per level
};

/// Batches that are certified one after the other. Their inputs come from earlier steps or, in a
/// link, from earlier batches.
struct CertificationStep {
  std::vector<BlockBatch> batches;
  int link = -1;  ///< position of their group's link in BlockSchedule::links. -1: none
};

/// The blocks of a model in an order of solution. A batch holds blocks of one shape that do not
/// read each other.
struct BlockSchedule {
  std::vector<CertificationStep> steps;
  std::vector<ChainLink> links;
  std::vector<GroupInterface> interfaces;
  BatchSizes largest;
  int lent_rows = 0, max_generators = 0;  ///< sizes of ErrorTable
};

/// Cuts a model into blocks. levels: level up to which each coordinate is solved; empty: all
/// levels. Errors go from block to block as boxes. Groups of long chains, where boxes may grow
/// without limit, are links: ErrorSets::bases hands on their errors in bases.
BlockSchedule block_schedule(const Model& model, std::span<const Level> levels);

}  // namespace desmo
