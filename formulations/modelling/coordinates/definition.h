#pragma once

#include <array>

#include "formulations/constraints/constraints.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

/// The definition of a relative coordinate: a constraint between it and points or vectors.
struct Definition {
  EquationWriter& writer;
  const Mechanism::Coordinate& coordinate;
  EntityId value;  ///< entity of the coordinate

  /// Writes the definition as a constraint of this kind.
  template <class Kind>
  void as(const std::array<EntityId, Kind::operand_sizes.size()>& operands,
          const std::array<double, Kind::constants>& constants = {}) const {
    writer.constrain<Kind>(Origin::coordinate, coordinate.name + ": definition", operands,
                           constants);
  }
};

/// Writes the definition of an angle in the plane. Throws std::invalid_argument, naming the
/// coordinate, when one of its lines lies on no single body, so that its length may change.
void define_planar_angle(const Definition& definition);

/// Writes the definition of an angle in space. Throws std::invalid_argument, naming the coordinate,
/// when the rotating direction is not in the plane of the angle in the nominal position.
void define_spatial_angle(const Definition& definition);

}  // namespace desmo
