#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <vector>

#include "formulations/equations/pattern.h"
#include "formulations/verification/reference/whole_system.h"

namespace desmo {

class KluFactors;

/// All equations of a mechanism, their unknowns in magnitudes of their own (CharacteristicLengths)
/// and their rows over what they sum up to: A = R⁻¹ Φ_φ S, so that ‖A‖∞ = 1, with its factors.
/// Analysed at construction; nothing is taken from the heap afterwards but by KLU.
class ScaledSystem {
 public:
  using Array = Eigen::ArrayXd;

  /// The mechanism must outlive it.
  explicit ScaledSystem(const Model& model);
  ~ScaledSystem();

  const WholeSystem& equations() const { return equations_; }
  int size() const { return pattern_.n; }
  const std::vector<int>& unknowns() const { return pattern_.unknowns; }
  GroupId group_of_row(int row) const { return row_groups_[row]; }
  double magnitude(int coordinate) const { return magnitude_[coordinate]; }
  std::span<const double> magnitudes() const { return magnitude_; }
  bool is_unknown(int state) const { return column(state) >= 0; }
  int column(int state) const { return equations_.column(state); }

  /// How many unknowns the irreducible block of one has.
  int block_size(int unknown) const { return block_size_[unknown]; }

  /// Factorises at a state; false when A is singular in double precision. state: q and the fixed
  /// components.
  bool factorise(std::span<const double> state);
  /// Where factorise() gave up.
  GroupId singular_group() const;

  // What follows is that of the last successful factorise().

  const Array& row_sums() const { return row_sums_; }
  /// The same equations in the magnitudes of verification/condition.h, those of the whole
  /// mechanism, are F⁻¹ A W⁻¹: W of each unknown, F of each row.
  const Array& unknown_shares() const { return unknown_shares_; }
  const Array& row_shares() const { return row_shares_; }
  /// x = A⁻¹ x, A⁻ᵀ x
  void solve(double* x);
  void solve_transposed(double* x);
  /// x of each unknown, in its magnitude, when every driver moves by plus or minus its own.
  /// Once after each factorise().
  const Array& sensitivities();
  /// The sign of det A of each irreducible block, up to one that never changes: a motion takes it
  /// through zero only.
  std::span<const signed char> orientation() const { return orientation_; }
  GroupId group_of_block(int block) const;

 private:
  void lay_out();
  void orient();

  WholeSystem equations_;
  std::vector<double> magnitude_;      // of each coordinate
  std::vector<double> of_whole_;       // the same in verification/condition.h
  std::vector<double> driver_change_;  // of each component of the state: ± its magnitude, or 0
  std::vector<GroupId> row_groups_;
  Pattern pattern_;
  std::vector<int> slots_;  // of each entry that WholeSystem calls with; -1: of no unknown
  std::vector<double> values_;
  Array row_sums_, by_drivers_, unknown_shares_, row_shares_;
  std::unique_ptr<KluFactors> factors_;  // none where there is nothing to solve
  std::vector<signed char> orientation_;
  std::vector<int> block_size_;    // of each unknown
  std::vector<int> place_of_row_;  // in the order of the blocks
  std::vector<char> counted_;      // rows, by orient()
};

}  // namespace desmo
