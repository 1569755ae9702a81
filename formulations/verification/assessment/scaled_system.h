#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "formulations/equations/pattern.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

class KluFactors;

/// Norm in which unknowns are compared.
enum class Norm {
  of_blocks,  ///< each irreducible block for itself, in the lengths about its points
  of_whole,   ///< one for all bodies, in the size of the mechanism
};

/// Scaled linear system of a whole model, with factors: A = R⁻¹ Φ_φ S. The diagonal S holds the
/// magnitudes of the unknowns (CharacteristicLengths), the diagonal R the row sums of |Φ_φ S|; so
/// ‖A‖∞ = 1. The constructor analyses the pattern; afterwards only KLU allocates.
class ScaledSystem {
 public:
  using Array = Eigen::ArrayXd;

  /// The model must outlive this object.
  explicit ScaledSystem(const Model& model, Norm norm = Norm::of_blocks);
  ~ScaledSystem();

  Norm norm() const { return norm_; }
  const WholeSystem& equations() const { return equations_; }
  int size() const { return pattern_.n; }
  const std::vector<int>& unknowns() const { return pattern_.unknowns; }
  GroupId group_of_row(int row) const { return row_groups_[row]; }
  double magnitude(int coordinate) const { return magnitude_[coordinate]; }
  std::span<const double> magnitudes() const { return magnitude_; }
  /// Returns the magnitude of each coordinate as it would be with the lengths of positions q
  /// (coordinates), where the nominal ones may be far off.
  std::vector<double> magnitudes_at(std::span<const double> q) const;
  /// Returns the column of A of a component of the state; -1: it is not an unknown.
  int column(int component) const { return equations_.column(component); }
  bool is_unknown(int component) const { return column(component) >= 0; }

  /// Return the irreducible block of an unknown, and the number of unknowns in it.
  int block(int unknown) const { return block_[unknown]; }
  int block_size(int unknown) const { return block_size_[unknown]; }

  /// Factorises A at a state (q followed by the fixed components), unless it did so last. Returns
  /// false when A is singular in double precision.
  bool factor(std::span<const double> state);
  /// Returns the group in which the last factor() failed.
  GroupId singular_group() const;

  // The functions below refer to the last successful factor().

  /// Returns the diagonal of R.
  const Array& row_sums() const { return row_sums_; }
  /// Return the diagonals W (unknowns) and F (rows) of another scaling, which
  /// verification/condition.h uses: with the magnitudes of the whole mechanism, A becomes F⁻¹ A
  /// W⁻¹.
  const Array& unknown_shares() const { return unknown_shares_; }
  const Array& row_shares() const { return row_shares_; }
  /// Returns the sums of A's rows over the columns of their own irreducible blocks: what comes
  /// before a block may be much larger. Valid until the next call.
  const Array& block_row_sums();
  /// Overwrite X (unknowns × right_sides, column by column) with A⁻¹ X and A⁻ᵀ X.
  void solve(double* x, int right_sides = 1);
  void solve_transposed(double* x, int right_sides = 1);
  /// Overwrite X (unknowns × right_sides) with D⁻¹ X and D⁻ᵀ X, D being the irreducible blocks of A
  /// without what couples them. In a norm of the whole, D is A.
  void solve_blocks(double* x, int right_sides = 1);
  void solve_blocks_transposed(double* x, int right_sides = 1);
  /// Returns the change of each unknown, in its magnitude and up to sign, when every driver moves
  /// by plus or minus its own magnitude. Valid until the next call.
  const Array& sensitivities();
  /// Returns the sign of det A of each irreducible block, up to a constant sign of the block. A
  /// continuous motion changes it only by passing det A = 0.
  std::span<const signed char> orientation() const { return orientation_; }
  /// Returns log |det Φ_φ S| of an irreducible block: smooth along a motion, unlike det A.
  double log_determinant(int block) const;
  GroupId group_of_block(int block) const;

 private:
  void lay_out();
  void orient();

  const Model& model_;
  const Norm norm_;
  WholeSystem equations_;
  std::vector<double> magnitude_;      // magnitude of each coordinate
  std::vector<double> of_whole_;       // magnitude of each coordinate in verification/condition.h
  std::vector<double> driver_change_;  // for each state component: ± magnitude of a driver, else 0
  std::vector<GroupId> row_groups_;
  Pattern pattern_;
  std::vector<int> slots_;  // position in values_ of each WholeSystem entry; -1: not an unknown
  std::vector<double> values_;
  std::vector<double> state_;  // that of the factors; empty: there are none
  Array row_sums_, by_drivers_, sensitivities_, unknown_shares_, row_shares_, block_row_sums_;
  std::unique_ptr<KluFactors> factors_;  // null when there are no unknowns
  std::vector<signed char> orientation_;
  std::vector<int> block_, block_size_;  // for each unknown
  std::vector<int> place_of_row_;        // position of each row in block order
  std::vector<char> counted_;            // marks rows in orient()
};

/// The irreducible blocks of a system without what couples them, as InverseNorm solves.
struct IrreducibleBlocks {
  ScaledSystem& system;
  void solve(double* x) { system.solve_blocks(x); }
  void solve_transposed(double* x, int right_sides) {
    system.solve_blocks_transposed(x, right_sides);
  }
};

}  // namespace desmo
