#pragma once

#include <vector>

#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"
#include "formulations/verification/certificate/single_matrix.h"

namespace desmo {

/// An approximate inverse Y of the matrices Φ_φ (n × n) of four blocks, and what depends on it. An
/// inaccurate inverse only makes a proof fail.
struct Preconditioner {
  std::vector<LaneNumbers> inverse;  ///< Y (n × n)
  std::vector<LaneNumbers>
      remainder;  ///< |I − Y Φ_φ|, rounded, without what rounding Y Φ_φ adds (n × n)
  std::vector<LaneNumbers> slopes;  ///< |Y Φ_h|, rounded, h: the m inputs (n × m)

  void resize(int n, int m);
  /// Finds all from the midpoints of Φ_q. Lanes share pivots where these suit all.
  void find(const BlockShape& shape, const LaneNumbers* jacobian, LaneMask lanes);
  /// Returns the condition number of Φ_φ, rounded: ‖S⁻¹ Y R‖∞. S holds the magnitudes of the
  /// unknowns, R the row sums of |Φ_q| with the magnitudes of all n + m columns. Infinite where the
  /// matrix is singular in doubles.
  LaneNumbers condition(const BlockShape& shape, const LaneNumbers* jacobian,
                        const LaneNumbers* magnitudes);

 private:
  void invert(const BlockShape& shape, const LaneNumbers* jacobian, LaneMask lanes);
  template <int N>
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
  void find_remainder(const BlockShape& shape, const LaneNumbers* jacobian);

  std::vector<LaneNumbers> work_;    // (n × n)
  std::vector<LaneNumbers> scales_;  // of rows (n): for pivots, and R
  std::vector<int> rows_;            // of the pivots (n)
  bool is_single_ = false;           // all lanes have the same matrix
  SingleMatrix single_;
};

}  // namespace desmo
