#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Determinants of Φ_φ of the irreducible blocks of a model at a position, in solution order. Empty
/// if one is zero or not finite.
struct Determinants {
  std::vector<double> logs;  ///< log |det|, with columns times characteristic lengths
  std::vector<signed char> signs;

  bool empty() const { return signs.empty(); }
  /// Returns the blocks whose determinants have another sign at another position; none if either is
  /// empty.
  std::vector<int> changed(const Determinants& other) const;
};

/// Evaluator of these determinants. A continuous motion changes the sign of one only by passing a
/// singular position.
class BlockDeterminants {
 public:
  /// The model must outlive this object.
  explicit BlockDeterminants(const Model& model);

  /// Evaluates all determinants at a state: q followed by the fixed components.
  Determinants at(std::span<const double> state) const;

  GroupId group(int block) const { return blocks_[block].groups.front(); }

 private:
  const Model& m_;
  std::vector<PartDefinition> blocks_;
  std::vector<double> unit_;  // Σ log of the characteristic lengths of each block's unknowns
};

}  // namespace desmo
