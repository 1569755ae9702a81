#pragma once

#include <vector>

#include "formulations/modelling/independence/sampled_positions.h"

namespace desmo {

/// The independent equations of a group.
struct SelectedRows {
  std::vector<bool> taken;  ///< rows of the system that are selected
  /// Largest relative uncertainty of a row's derivatives by rounding of positions; 0 when enough
  /// rows are selected.
  double uncertain = 0;
  SampledJacobians jacobians;
};

/// A selector of independent equations among a group's candidates; see leave_out_dependent.
class RowSelector {
 public:
  /// Stores references: all arguments must outlive the selector.
  RowSelector(Model& candidates, const SampledPositions& positions, Linearisers& linearisers)
      : m_(candidates), positions_(positions), linearisers_(linearisers) {}

  SelectedRows select(const GroupSystem& system);

  /// Replaces definitions with one selected equation by their ScalarDefinition, in the candidates,
  /// the system and the selection. The sine or the cosine of an angle alone would be singular at
  /// some positions. Does not if fewer rows would then be selected.
  void shorten(GroupSystem& system, SelectedRows& selected);

 private:
  std::vector<int> preference(const GroupSystem& system) const;
  bool shorten_definitions(const GroupSystem& system, const std::vector<bool>& taken);

  Model& m_;
  const SampledPositions& positions_;
  Linearisers& linearisers_;
};

}  // namespace desmo
