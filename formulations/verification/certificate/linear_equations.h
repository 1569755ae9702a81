#pragma once

#include <span>
#include <vector>

#include "cases/numbers/compensated.h"
#include "cases/numbers/interval.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

using LaneInterval = BasicInterval<LaneNumbers>;

/// An interval matrix for each lane, with the entries that BlockShape::entries lists. Midpoints and
/// radii are kept apart.
struct LaneMatrix {
  std::vector<LaneNumbers> mid, radius;

  void resize(int entries) { mid.resize(entries), radius.resize(entries); }
  /// Sets an entry; -1: none.
  void set(int entry, const LaneInterval& value) {
    if (entry < 0) return;
    mid[entry] = value.mid;
    radius[entry] = value.radius;
  }
};

/// The linear ones among the n equations of a batch: Φ = Σ factor × local state + Φ(0). Proofs
/// about instants and about paths take them from here.
class LinearEquations {
 public:
  /// A term of an equation: factor × local state.
  struct Term {
    int row, state;
    int slot;  ///< in the Jacobian; -1: none
    Compensated<LaneNumbers> factor;
    LaneInterval enclosed;  ///< the factor, about its double
  };

  LinearEquations() = default;
  /// Takes the linear ones of a shape.
  /// - constants: of all objects
  /// - remainders: what fixed local states lack of those in the file; 0 for others
  LinearEquations(const BlockShape& shape, const std::vector<Compensated<LaneNumbers>>& constants,
                  const std::vector<Compensated<LaneNumbers>>& remainders);

  /// Calls visit(row, terms) for each equation.
  template <class Visit>
  void for_each_row(Visit&& visit) const {
    for (std::size_t first = 0, end = 0; first < terms_.size(); first = end) {
      const int row = terms_[first].row;
      while (end < terms_.size() && terms_[end].row == row) ++end;
      visit(row, std::span(terms_).subspan(first, end - first));
    }
  }
  /// Returns Φ(0) of a row, about its double.
  const LaneInterval& at_origin(int row) const { return at_origin_[row]; }

  /// Evaluates Φ and its time derivatives up to a level, nearly without rounding. Overwrites the
  /// rows of linear equations in phi.
  void motion(const PerLevel<const LaneInterval*>& x, Level level,
              const PerLevel<LaneInterval*>& phi) const;
  /// Writes the entries of linear equations in Φ_q, as midpoints and radii, and zeros elsewhere.
  void jacobian(LaneMatrix& to) const;

 private:
  void add(const BlockShape::Object& object, const Compensated<LaneNumbers>* constants);
  void add_remainders(const std::vector<Compensated<LaneNumbers>>& remainders);

  std::vector<Term> terms_;              // by rows
  std::vector<LaneInterval> at_origin_;  // (n)
  /// Sums that Φ(0) and remainders of fixed states add to rows of terms (n); empty: none.
  std::vector<Compensated<LaneNumbers>> offsets_;
};

}  // namespace desmo
