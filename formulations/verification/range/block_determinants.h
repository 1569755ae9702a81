#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Determinants of Φ_φ of the irreducible blocks of a model. A continuous motion changes the sign
/// of one only by passing a singular position.
class BlockDeterminants {
 public:
  /// The model must outlive this object.
  explicit BlockDeterminants(const Model& model);

  /// Evaluates all of them at a state (q followed by the fixed components). Returns false where one
  /// is zero or not finite; all of them then stay as they were.
  bool evaluate(std::span<const double> state);

  int blocks() const { return static_cast<int>(blocks_.size()); }
  std::span<const signed char> signs() const { return signs_; }
  /// Returns the logarithm of a magnitude, with lengths in those about each point.
  double log(int block) const { return logs_[block]; }
  GroupId group(int block) const { return blocks_[block].groups.front(); }

 private:
  const Model& m_;
  std::vector<PartDefinition> blocks_;
  std::vector<double> unit_;  // logarithm of each block's lengths
  std::vector<double> logs_;
  std::vector<signed char> signs_;
};

}  // namespace desmo
