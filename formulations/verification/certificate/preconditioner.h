#pragma once

#include <vector>

#include "formulations/verification/certificate/lanes.h"

namespace desmo {

/// An approximate inverse Y of the matrices Φ_φ (n × n) of four blocks, and what depends on it. An
/// inaccurate inverse only makes a proof fail.
struct Preconditioner {
  std::vector<Lanes> inverse;  ///< Y (n × n)
  std::vector<Lanes> remainder;  ///< |I − Y Φ_φ|, rounded, without what rounding Y Φ_φ adds (n × n)
  std::vector<Lanes> slopes;  ///< |Y Φ_h|, rounded, h: the m inputs (n × m)
  std::vector<Lanes> work;    ///< (n × n)
  std::vector<Lanes> scales;  ///< of rows (n)
  std::vector<int> rows;      ///< row of each pivot (n)

  void resize(int n, int m);
  /// Finds all from the midpoints of Φ_q (n × (n + m)). Lanes share pivots where these suit all.
  void find(const Lanes* jacobian, int n, int m, LaneMask lanes);

 private:
  void invert(const Lanes* jacobian, int n, int stride, LaneMask lanes);
};

}  // namespace desmo
