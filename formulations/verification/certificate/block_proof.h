#pragma once

#include <array>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_batch.h"
#include "formulations/verification/certificate/error_table.h"

namespace desmo {

/// Krawczyk's test of batches of blocks, one after the other, and the memory that it needs.
class BlockProof {
 public:
  /// Makes room for batches up to these sizes.
  BlockProof(int max_unknowns, int max_inputs, int max_states, int max_columns);

  /// Proves bounds on the errors of the unknowns, up to a level. delivered: the state of the model.
  /// errors: those of the inputs are known. Writes those of the unknowns; their sum is infinite
  /// where no proof succeeds. Returns in which lanes each level is proven.
  PerLevel<LaneMask> prove(BlockBatch& batch, const PerLevel<std::vector<double>>& delivered,
                           Level level, PerLevel<ErrorTable>& errors);

 private:
  /// Errors of all columns at one level. Those of unknowns are zero while they are not known.
  struct Errors {
    std::vector<Lanes> center, own, sum;
  };
  /// factor × derivative times the errors of a lower level: a term of an equation for rates.
  struct LowerTerm {
    Level derivative;
    double factor;
    Level errors;
  };
  int n() const { return batch_->equations.shape().unknowns; }
  int width() const { return batch_->equations.shape().width(); }

  void gather(Level level, const std::vector<double>& delivered, const ErrorTable& errors);
  LaneMask known_inputs(Level level) const;
  LaneMask prove_positions(PerLevel<ErrorTable>& errors, LaneMask lanes);
  LaneMask bound_rates(Level level, PerLevel<ErrorTable>& errors, LaneMask lanes);
  void widen(Level level);
  template <int N>
  void find_image(Level level);
  void find_generators(Level level, PerLevel<ErrorTable>& errors);
  template <int N>
  void contract();
  void add_contraction(Level level, const Lanes& factor);
  void scatter(Level level, LaneMask proven, ErrorTable& to) const;

  BlockBatch* batch_ = nullptr;
  const Preconditioner* y_ = nullptr;
  std::vector<LowerTerm> lower_;               // of the present level
  PerLevel<std::vector<LaneInterval>> state_;  // local states
  PerLevel<std::vector<LaneInterval>> phi_;    // Φ, Φ̇, Φ̈ of the delivered values (n)
  PerLevel<LaneMatrix> rates_;                 // Φ̇_q, Φ̈_q (n × (n + m))
  PerLevel<Errors> errors_;                    // (n + m)
  Preconditioner preconditioner_;
  std::vector<Lanes> center_, uncertainty_;  // of the equations (n)
  std::vector<Lanes> trial_;                 // radii of X (n)
  std::vector<Lanes> contracted_;            // bound on |(I − Y Φ_φ(X)) X| (n)
  std::vector<double> generators_;           // of the equations (n × columns)
};

}  // namespace desmo
