#pragma once

#include <vector>

#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// Approximate inverses Y of the matrices Φ_φ (n × n) of four blocks, and products with them. An
/// inaccurate inverse can only make a proof fail. BlockBatch::rounding covers the rounding of
/// products.
struct Preconditioner {
  std::vector<LaneNumbers> inverse;    ///< Y (n × n)
  std::vector<LaneNumbers> remainder;  ///< |I − Y Φ_φ| as computed (n × n)
  std::vector<LaneNumbers> slopes;     ///< |Y Φ_h| as computed, h: the m inputs (n × m)

  void resize(int n, int m);
  /// Finds Y, remainder and slopes from the midpoints of Φ_q. Lanes share pivots; a lane that these
  /// do not suit gets its own. lanes: the ones that count.
  void find(const BlockShape& shape, const LaneNumbers* jacobian, LaneMask lanes);
  /// Returns the condition number of Φ_φ, rounded: ‖S⁻¹ Y R‖∞. S holds the magnitudes of the
  /// unknowns, R the row sums of |Φ_q| with the magnitudes of all n + m columns. Infinite where the
  /// matrix is singular in doubles.
  LaneNumbers condition(const BlockShape& shape, const LaneNumbers* jacobian,
                        const LaneNumbers* magnitudes);

 private:
  void invert(const BlockShape& shape, const LaneNumbers* jacobian, LaneMask lanes);
  template <class S, int N>
  void invert(const BlockShape& shape, const LaneNumbers* jacobian, LaneMask lanes);
  void invert_three(const BlockShape& shape, const LaneNumbers* jacobian);
  void multiply(const BlockShape& shape, const LaneNumbers* jacobian, int first, int last,
                LaneNumbers* to);
  template <int N>
  void multiply(const BlockShape& shape, const LaneNumbers* jacobian, int first, int last,
                LaneNumbers* to) const;
  template <int N, int Count>
  void multiply(const int* rows, const int* entries, const LaneNumbers* jacobian, int size, int one,
                LaneNumbers* to, int stride) const;
  void multiply_single(const BlockShape& shape, const LaneNumbers* jacobian, int first, int last,
                       LaneNumbers* to);

  std::vector<double> work_;    // rows of Φ_φ, then of Y
  std::vector<double> scales_;  // of rows: for pivots, and R
  std::vector<int> rows_;       // row exchanged with row k in step k of an elimination (n)
  // All lanes have the same matrix, with more than four unknowns. Registers of `work_` then hold
  // four columns of Φ_φ, and those of `columns_` four rows of Y, in place of four blocks.
  bool is_single_ = false;
  std::vector<LaneNumbers> columns_;  // columns of Y, each in registers(n); then a workspace
};

}  // namespace desmo
