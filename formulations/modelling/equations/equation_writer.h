#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formulations/model/constrain.h"
#include "formulations/modelling/equations/candidates.h"

namespace desmo {

/// A writer of candidate equations: adds them to the model of the coordinates.
class EquationWriter {
 public:
  /// Takes over the coordinates. mechanism and rigid must outlive the writer.
  EquationWriter(const Mechanism& mechanism, const RigidBodies& rigid, Coordinates coordinates);

  const Mechanism& mechanism;
  const RigidBodies& rigid;
  const double reach;  ///< largest absolute coordinate of a point, nominally

  EntityId point(int p) const { return coordinates_.points[p]; }
  EntityId vector(int v) const { return coordinates_.vectors[v]; }
  /// Returns the coordinates; their model contains the equations written so far.
  const Coordinates& coordinates() const { return coordinates_; }

  EntityId add_fixed_vector(std::string name, const Mechanism::Vec& direction);

  /// Adds an equation to the last group that solves for one of its operands. Adds nothing when all
  /// operands are fixed.
  template <class Kind>
  void constrain(Origin origin, std::string name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<double, Kind::constants>& constants) {
    const GroupId g = last_group({operands.begin(), operands.end()});
    if (g < 0) return;
    desmo::constrain<Kind>(coordinates_.model, g, std::move(name), operands, constants);
    origins_.push_back(origin);
  }

  /// Records the constant scalar product of two directions. Returns whether it needs an equation:
  /// bodies that share both directions need one, unless their products differ.
  bool note_product(const Mechanism::Direction& a, const Mechanism::Direction& b, double product);

  /// Returns the text of a direction in equation names: "v" or "P-Q".
  std::string text(const Mechanism::Direction& direction) const;

  /// Returns all candidates in group order; leaves the writer empty.
  Candidates release();

 private:
  GroupId last_group(const std::vector<EntityId>& operands) const;

  using Key = std::array<int, 3>;
  Coordinates coordinates_;
  std::vector<Origin> origins_;  // source of each constraint
  std::map<std::pair<Key, Key>, double> products_;
};

/// Returns zero for a value at rounding level, |value| ≤ 16 ε · magnitude, otherwise the value.
double snap(double value, double magnitude);

/// Writes the equations within the bodies of a D-dimensional mechanism. Ground vectors that are
/// coordinates are held constant. Every other body keeps the scalar products of its basis; its
/// other points and vectors are linear functions of the basis.
template <int D>
void write_body_equations(EquationWriter& writer);

/// Writes the equations of joints between different rigid bodies: offsets of planar sliding joints
/// whose distance is not declared, and angles of universal joints. Shared points and vectors and
/// relative coordinates imply all others.
void write_joint_equations(EquationWriter& writer);

/// Writes the definitions of all relative coordinates, in D dimensions. Throws
/// std::invalid_argument, naming the coordinate, when a definition does not fit the nominal
/// position or cannot be written.
template <int D>
void write_coordinate_equations(EquationWriter& writer);

}  // namespace desmo
