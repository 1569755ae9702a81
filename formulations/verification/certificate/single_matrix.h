#pragma once

#include <vector>

#include "formulations/verification/certificate/block_shape.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// The matrix Φ_φ (n × n) of a block that is alone in its batch, and its inverse Y. Registers hold
/// four columns of Φ_φ, or four rows of Y, in place of four blocks.
class SingleMatrix {
 public:
  void resize(int n);

  /// Inverts Φ_φ by Gauss–Jordan elimination, from the first lane of Φ_q. Writes Y (n × n) to all
  /// lanes.
  void invert(const BlockShape& shape, const LaneNumbers* jacobian, LaneNumbers* inverse);
  /// Writes |D − Y C| (n × (last − first)) to all lanes, with the Y that invert() found. C are the
  /// columns first … last − 1 of Φ_q. D is I in the columns of unknowns, 0 in those of inputs.
  void multiply(const BlockShape& shape, const LaneNumbers* jacobian, int first, int last,
                LaneNumbers* to);

 private:
  void write_inverse(LaneNumbers* to);

  int n_ = 0, stride_ = 0;       // stride: n rounded up to whole registers
  std::vector<double> rows_;     // rows of Φ_φ, then those of Y with columns in another order
  std::vector<double> columns_;  // columns of Y
  std::vector<double> scales_;   // 1/largest entry of each row, for pivots
  std::vector<int> order_;       // place of each column of Y among the columns of rows_
  std::vector<int> pivots_;      // row of the pivot of each step
  std::vector<double> product_;  // workspace: a column of D − Y C
};

}  // namespace desmo
