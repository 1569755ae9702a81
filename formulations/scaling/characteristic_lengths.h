#pragma once

#include <span>
#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// The lengths that points and distances are judged by: those of the bodies about them, not of the
/// whole mechanism, in which a small part may be beside a large one.
class CharacteristicLengths {
 public:
  /// At the nominal position (the estimate).
  explicit CharacteristicLengths(const Model& model);
  /// At a position found, where the estimate may be far from any. q: its coordinates.
  CharacteristicLengths(const Model& model, std::span<const double> q);

  /// Of a point or a distance: the largest distance between points that constraints join to it, or
  /// of the distances themselves. Where all these points coincide it is the largest such length of
  /// its group, or of the mechanism, or 1.
  double of(EntityId entity) const;

  /// For each coordinate that of its point or distance; 1 for those of vectors and angles.
  std::vector<double> of_coordinates() const;

  /// Of a constraint: the largest of its points and distances; where they all coincide, likewise.
  double of(const Constraint& constraint) const;

 private:
  double or_wider(double length, GroupId group) const;

  const Model& m_;
  std::vector<double> about_, of_group_;  // 0: no length
  double of_all_ = 0;
};

}  // namespace desmo
