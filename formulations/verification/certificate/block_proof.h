#pragma once

#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/error_table.h"

namespace desmo {

/// Krawczyk's test of blocks, one batch at a time. It proves that exactly one solution lies within
/// intervals around the delivered values.
class BlockProof {
 public:
  /// Allocates for batches up to these sizes.
  explicit BlockProof(const BatchSizes& largest);

  /// Proves bounds on the errors of a batch's unknowns, up to a level. Returns in which lanes each
  /// level is proven.
  /// - errors: in, errors of the inputs; out, errors of the unknowns, whose sum is infinite where
  ///   no proof succeeds
  /// - time: of the instant; only a homotopy reads it
  PerLevel<LaneMask> prove(BlockBatch& batch, Level level, PerLevel<ErrorTable>& errors,
                           double time = 0);
  /// Returns why a lane of the batch that prove() took last is not proven.
  ProofFailure failure(int lane) const;
  /// Returns the condition number of each block of that batch (Preconditioner::condition); 0 where
  /// the positions of the block's inputs have unbounded errors.
  const LaneNumbers& condition() const { return condition_; }

 private:
  /// Errors at one level of each column of a block (n + m), as in ErrorTable::Row. Errors of the
  /// unknowns are bounds only after finish().
  struct ErrorColumns {
    std::vector<LaneNumbers> centre, own, sum;
    std::vector<LaneNumbers> weight;  ///< own + rounding × sum
  };
  /// Term of an equation for rates: factor × Φ̇_q or Φ̈_q × the errors of a lower level.
  struct LowerTerm {
    Level derivative;
    double factor;
    Level errors;
  };

  LaneMask gather(Level level, const ErrorTable& errors);
  void add_homotopy(Level level, double time);
  LaneMask prove_positions(PerLevel<ErrorTable>& errors, LaneMask lanes);
  LaneMask bound_rates(Level level, PerLevel<ErrorTable>& errors, LaneMask lanes);
  void finish(Level level, const LaneNumbers& factor);
  void scatter(Level level, LaneMask tried, LaneMask proven, ErrorTable& to) const;

  // In block_image.cpp. N: see with_unrolled_size().
  void find_image(Level level, PerLevel<ErrorTable>& errors);
  template <int N>
  void find_image(Level level);
  void find_generators(Level level, PerLevel<ErrorTable>& errors);

  BlockBatch* batch_ = nullptr;
  const BlockShape* shape_ = nullptr;
  Level up_to_ = Level::position;
  const Preconditioner* y_ = nullptr;
  std::vector<LowerTerm> lower_;               // terms of the present level
  PerLevel<std::vector<LaneInterval>> state_;  // local states
  PerLevel<std::vector<LaneInterval>> phi_;    // Φ, Φ̇, Φ̈ of the delivered values (n)
  PerLevel<LaneMatrix> rates_;                 // Φ̇_q, Φ̈_q
  PerLevel<ErrorColumns> errors_;              // (n + m)
  Preconditioner preconditioner_;
  LaneNumbers condition_;
  // Midpoints and radii of Φ + Φ_h δ (n), before they are multiplied by Y. At rates, Φ̇ or Φ̈ takes
  // the place of Φ, and lower terms are added. h: inputs; δ: their errors.
  std::vector<LaneNumbers> centre_, uncertainty_;
  std::vector<LaneNumbers> trial_;       // radii of X (n)
  std::vector<LaneNumbers> contracted_;  // bound on |(I − Y Φ_φ(X)) X| (n)
  std::vector<double> generators_;       // G (ErrorTable) of what centre_ holds (n × columns)
};

}  // namespace desmo
