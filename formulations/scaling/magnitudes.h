#pragma once

#include <cstddef>
#include <vector>

#include "formulations/model/model.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// The natural magnitude of every equation of a mechanism, so that Φ can be judged whatever the
/// units are: an equation divided by its magnitude tells, to first order, by how much of their own
/// magnitudes the coordinates that it joins are wrong.
///
/// The magnitude of a coordinate is 1 if it belongs to a vector or an angle; if to a point or a
/// distance, it is the characteristic length of the constraint (characteristic_lengths.h).
///
/// The magnitude of an equation is ‖∂Φ/∂qⱼ · magnitude of qⱼ‖₂ over its operands at the nominal
/// position, which a rotation of the frame leaves alone; an equation whose derivatives vanish there
/// (a distance that starts at nothing) has a thousandth of its second-order change instead. It is
/// positive and finite. All lengths times λ: those of length equations are λ, of products λ² times
/// as large.
class Magnitudes {
 public:
  explicit Magnitudes(const Model& model);

  double of(const Equation& equation) const { return magnitude_[row_of(equation)]; }

  /// 1/magnitude of each equation of a part.
  std::vector<double> weights(const PartDefinition& part) const;

  /// ‖Φ‖₂ of a part's equations, each over its magnitude, that rounding leaves: of positions to
  /// double precision, at the nominal position and as far from it as its bodies are large. Newton's
  /// method gets no further. u Σⱼ |∂Φ/∂qⱼ| |qⱼ| an equation: it grows with the distance from the
  /// origin, for it is there that coordinates are rounded.
  double rounding(const PartDefinition& part) const;

  /// That of each unknown of a part, a point's and a distance's being its characteristic length.
  std::vector<double> of_unknowns(const PartDefinition& part) const;

 private:
  std::size_t row_of(const Equation& equation) const {
    return static_cast<std::size_t>(first_row_[equation.constraint] + equation.row);
  }

  std::vector<int> first_row_;                // of each constraint
  std::vector<double> magnitude_, rounding_;  // of each row
  std::vector<double> of_coordinate_;
};

}  // namespace desmo
