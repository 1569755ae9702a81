#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Determinants of Φ_φ of the irreducible blocks of a model at a position. Empty: one is zero or
/// not finite.
struct Determinants {
  std::vector<double> logs;  ///< of magnitudes, with lengths in those about each point
  std::vector<signed char> signs;

  bool empty() const { return signs.empty(); }
  /// Returns the blocks whose determinants have another sign at another position; none where either
  /// is empty.
  std::vector<int> changed(const Determinants& other) const;
};

/// Evaluates them. A continuous motion changes the sign of one only by passing a singular position.
class BlockDeterminants {
 public:
  /// The model must outlive this object.
  explicit BlockDeterminants(const Model& model);

  /// Evaluates all of them at a state (q followed by the fixed components).
  Determinants at(std::span<const double> state) const;

  GroupId group(int block) const { return blocks_[block].groups.front(); }

 private:
  const Model& m_;
  std::vector<PartDefinition> blocks_;
  std::vector<double> unit_;  // logarithm of each block's lengths
};

}  // namespace desmo
