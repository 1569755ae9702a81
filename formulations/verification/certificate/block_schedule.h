#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/model/model.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/group_interface.h"

namespace desmo {

/// A structural group that is a link of a long chain.
struct ChainLink {
  /// Lent rows of an interface that the group reads. All else it reads as boxes.
  struct Source {
    int interface;
    int row;     ///< the first one
    int symbol;  ///< number of symbols before its own, at each level
  };
  std::vector<Source> sources;
  std::vector<int> interfaces;  ///< those that later groups read of this one
  int symbols = 0;              ///< at each level
};

/// Batches that are certified one after the other. Their inputs come from earlier steps or, in a
/// link, from earlier batches.
struct CertificationStep {
  std::vector<BlockBatch> batches;
  int link = -1;  ///< position of their group's link in BlockSchedule::links. -1: none
};

/// The blocks of a model in an order of solution, equal and independent ones together.
struct BlockSchedule {
  std::vector<CertificationStep> steps;
  std::vector<ChainLink> links;
  std::vector<GroupInterface> interfaces;
  BatchSizes largest;
  int lent_rows = 0, max_generators = 0;  ///< of ErrorTable
};

/// Cuts a model into blocks. levels: up to which each coordinate is solved; empty: all. Errors go
/// from block to block as boxes, but along chains of many groups in bases: there boxes would grow
/// without limit.
BlockSchedule block_schedule(const Model& model, std::span<const Level> levels);

}  // namespace desmo
