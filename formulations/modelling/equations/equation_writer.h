#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formulations/modelling/equations/candidates.h"

namespace desmo {

/// What candidate equations are written from, and the mechanism that they join.
class EquationWriter {
 public:
  /// The description and its bodies must outlive it.
  EquationWriter(const Mechanism& mechanism, const RigidBodies& rigid, Coordinates coordinates);

  const Mechanism& mechanism;
  const RigidBodies& rigid;
  const double reach;  ///< largest nominal coordinate of a point

  EntityId point(int p) const { return coordinates_.points[p]; }
  EntityId vector(int v) const { return coordinates_.vectors[v]; }
  /// Their mechanism contains what has been written.
  const Coordinates& coordinates() const { return coordinates_; }

  EntityId add_fixed_vector(std::string name, const Mechanism::Vec& direction);

  /// Adds an equation of the last of the groups that find its operands; none when all are fixed,
  /// for then nothing in it can move.
  template <class Kind>
  void constrain(Origin origin, std::string name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<double, Kind::constants>& constants) {
    const GroupId g = last_group({operands.begin(), operands.end()});
    if (g < 0) return;
    coordinates_.model.constrain<Kind>(g, std::move(name), operands, constants);
    origins_.push_back(origin);
  }

  /// Notes a constant product of two directions. Returns whether it has to be stated: bodies that
  /// share both directions state it once, unless they contradict each other.
  bool note_product(const Mechanism::Direction& a, const Mechanism::Direction& b, double product);

  /// For the names of equations: "v" or "P-Q".
  std::string text(const Mechanism::Direction& direction) const;

  /// All that was written, in group order; leaves the writer empty.
  Candidates take();

 private:
  GroupId last_group(const std::vector<EntityId>& operands) const;

  using Key = std::array<int, 3>;
  Coordinates coordinates_;
  std::vector<Origin> origins_;  // of the mechanism's constraints
  std::map<std::pair<Key, Key>, double> products_;
};

/// Zero when a value is what rounding leaves of products of this magnitude.
double snap(double value, double magnitude);

}  // namespace desmo
