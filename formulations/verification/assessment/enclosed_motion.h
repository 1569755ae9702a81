#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/groupwise/jet.h"
#include "formulations/model/model.h"
#include "formulations/scaling/scales.h"
#include "formulations/verification/assessment/rounded.h"

namespace desmo {

/// Returns the component of a jet that belongs to a level.
template <class S>
constexpr S Jet<S>::*order_of(Level level) {
  return level == Level::position   ? &Jet<S>::value
         : level == Level::velocity ? &Jet<S>::first
                                    : &Jet<S>::second;
}

/// A solved instant with its uncertainty: rounding of the drivers' motions, error bounds of the
/// unknowns. Rates that are not solved are zero.
class EnclosedMotion {
 public:
  /// levels: the level up to which each coordinate is solved. Both must outlive this object.
  EnclosedMotion(const Model& model, std::span<const Level> levels);

  /// Takes an instant: drivers with their rounding, unknowns as exact.
  void take(const Instant& instant);
  /// Sets the error bounds of solved unknowns at a level. errors: one for each of `unknowns`, in
  /// the coordinates' units.
  void widen(Level level, std::span<const int> unknowns, const Eigen::ArrayXd& errors);
  /// Returns the largest uncertainty of a driver relative to its scale.
  double of_drivers(Level level, const Scales& scales) const;

  std::span<const Jet<Rounded>> state() const { return state_; }
  std::span<const Rounded> positions();  ///< positions of state()
  double scale(int coordinate, Level level, const Scales& scales) const {
    return scales.of(kind(coordinate), level);
  }
  EntityKind kind(int coordinate) const { return model_.entities[entity_[coordinate]].kind; }
  int size_of_output(int coordinate) const { return model_.entities[entity_[coordinate]].size; }
  GroupId group(int coordinate) const { return model_.entities[entity_[coordinate]].group; }
  bool is_solved(int coordinate, Level level) const { return levels_[coordinate] >= level; }

 private:
  const Model& model_;
  std::span<const Level> levels_;
  std::vector<EntityId> entity_;  // entity of each coordinate
  std::vector<Jet<Rounded>> state_;
  std::vector<Rounded> positions_;
};

}  // namespace desmo
