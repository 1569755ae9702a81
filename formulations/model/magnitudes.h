#pragma once

#include <cstddef>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/model/partition.h"

namespace desmo {

/// Natural magnitude of every equation of a model, which makes Φ comparable in any units. An
/// equation divided by its magnitude states, to first order, the error of its coordinates relative
/// to their own magnitudes.
///
/// The magnitude of a coordinate is 1 for a vector or an angle. For a point or a distance it is the
/// characteristic length of the constraint (characteristic_lengths.h).
///
/// The magnitude of an equation is the Euclidean norm of ∂Φ/∂qⱼ · magnitude of qⱼ over its
/// coordinates, at the nominal position. Rotations of the coordinate system do not change this
/// norm. It vanishes for a distance that starts at zero. The magnitude is therefore at least a
/// thousandth of the second-order change of Φ by displacements of these magnitudes. Where both
/// vanish it is 1. It is positive and finite. When all lengths grow by a factor λ, it grows by λ
/// for equations in lengths, by λ² for products of lengths.
class Magnitudes {
 public:
  explicit Magnitudes(const Model& model);

  double of(const Equation& equation) const { return magnitude_[row_of(equation)]; }

  /// Returns 1/magnitude of each equation of a part.
  std::vector<double> weights(const PartDefinition& part) const;

  /// Returns the rounding floor of a part: ‖Φ‖₂, each equation divided by its magnitude, that
  /// rounding positions to double precision may leave. Newton's method gets no further. An equation
  /// contributes u Σⱼ |∂Φ/∂qⱼ| |qⱼ| with u = 2⁻⁵³, where |qⱼ| includes one characteristic length of
  /// motion. The floor grows with the distance from the origin, where coordinates are rounded more
  /// coarsely.
  double rounding(const PartDefinition& part) const;

  /// Returns the magnitude of each unknown of a part: 1, or the characteristic length of its point
  /// or distance.
  std::vector<double> of_unknowns(const PartDefinition& part) const;

 private:
  std::size_t row_of(const Equation& equation) const {
    return static_cast<std::size_t>(first_row_[equation.constraint] + equation.row);
  }

  std::vector<int> first_row_;                // row of each constraint's first equation
  std::vector<double> magnitude_, rounding_;  // of each row of a constraint
  std::vector<double> of_coordinate_;
};

}  // namespace desmo
