#pragma once

#include <vector>

#include "formulations/model/model.h"

namespace desmo {

/// Returns whether a constraint joins two points or more. A distance coordinate is then one between
/// points. Otherwise it may be a component of one point, which tells where the origin of
/// coordinates is.
bool joins_points(const Model& model, const Constraint& constraint);

/// Characteristic lengths of points and distances, against which errors are measured. They come
/// from the bodies around a point, not from the whole mechanism: a small part may be next to a
/// large one.
class CharacteristicLengths {
 public:
  /// Takes the lengths at the nominal position (the model's initial estimate). Stores a reference:
  /// the model must outlive the lengths.
  explicit CharacteristicLengths(const Model& model);

  /// Returns the length of a point or a distance. It is the largest distance between two points of
  /// a constraint on the entity, or the largest distance coordinate of such a constraint. Where a
  /// constraint does not join points, its distance coordinate counts as nominal_size() at most:
  /// such a coordinate may only tell where the origin is. When all are zero, returns the largest
  /// length of the entity's group, else of the mechanism, else 1.
  double of(EntityId entity) const;

  /// Returns the smallest length of these constraints that is not 0; falls back like of(entity).
  double shortest(EntityId entity) const;

  /// Returns the length of each coordinate's point or distance; 1 for vectors and angles.
  std::vector<double> of_coordinates() const;

  /// Returns the largest length of a constraint's points and distances; falls back like of(entity).
  double of(const Constraint& constraint) const;

  /// Returns the largest distance between two points of a constraint, or the largest of its
  /// distance coordinates. Returns of(constraint) where that is 0, as where two points are to
  /// coincide, and for a constraint without dimensions.
  double own(const Constraint& constraint) const;

 private:
  double extent(const Constraint& constraint) const;
  double or_wider(double length, GroupId group) const;

  const Model& m_;
  const double size_;                     // nominal_size() of the model
  std::vector<double> about_, of_group_;  // largest length on each entity, in each group; 0: none
  std::vector<double> shortest_;          // smallest positive length on each entity; 0: none
  double of_all_ = 0;
};

}  // namespace desmo
