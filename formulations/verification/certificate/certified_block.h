#pragma once

#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/interval_block.h"

namespace desmo {

/// Errors of one structural group at one level, row by row: first what it reads of others, then its
/// unknowns. Error i is center(i) + Σ G(i, k) t(k) with all |t(k)| ≤ 1.
struct ErrorRows {
  int columns = 0;
  std::vector<double> center, generators;  ///< (rows), (rows × columns)
  std::vector<double> sum;                 ///< |center(i)| + Σ |G(i, k)|, rounded up
  std::vector<double> radius;              ///< bound on |error i|

  double* of_row(int row) { return generators.data() + row * columns; }
  const double* of_row(int row) const { return generators.data() + row * columns; }
};

/// Intervals of whole states (Model::state_size()).
using IntervalState = PerLevel<std::vector<Interval>>;

/// An irreducible block, and what Krawczyk's test of it needs.
class CertifiedBlock {
 public:
  /// Places of a block's coordinates in ErrorRows.
  struct Places {
    std::vector<int> unknown_rows, input_rows;
    std::vector<int> symbols;  ///< column of each unknown's own error; -1: nobody reads it
    int first_symbol;          ///< number of columns before them
    int columns;               ///< number of all columns
  };

  /// magnitudes: of each unknown, against which errors of 1e-18 do not matter.
  CertifiedBlock(IntervalBlock equations, Places places, std::vector<double> magnitudes);

  const IntervalBlock& equations() const { return equations_; }
  const Places& places() const { return places_; }

  /// Proves a solution near the delivered positions. delivered: numbers without radius. state: the
  /// same numbers, radii of the inputs known. Writes the unknowns' rows and radii. Returns false
  /// where no proof succeeds; both are unspecified then.
  bool prove_positions(const IntervalState& delivered, IntervalState& state, ErrorRows& errors);
  /// Bounds velocities or accelerations, after prove_positions() has succeeded and all lower levels
  /// are bounded. Otherwise like prove_positions().
  bool bound_rates(Level level, const IntervalState& delivered, IntervalState& state,
                   ErrorRows& errors);

 private:
  int size() const { return equations_.size(); }
  int inputs() const { return static_cast<int>(places_.input_rows.size()); }
  bool invert();
  void find_slopes();
  void propagate(ErrorRows& errors) const;
  void find_uncertainty(const ErrorRows& errors);
  void contract();
  bool is_inside(const ErrorRows& errors) const;
  bool finish(ErrorRows& errors, std::vector<Interval>& state) const;

  IntervalBlock equations_;
  Places places_;
  std::vector<double> magnitudes_;
  double rounding_;                 // bound on the relative rounding of sums of products
  bool sloped_ = false;             // slopes are known, and constant
  IntervalMatrix jacobian_;         // (n × (n + m))
  std::vector<double> inverse_;     // Y (n × n)
  std::vector<double> remainder_;   // |I − Y Φ_φ| at the delivered values; workspace (n × n)
  std::vector<double> transfer_;    // −Y Φ_h (n × m)
  std::vector<Interval> phi_;       // Φ, Φ̇ or Φ̈ of the delivered values (n)
  std::vector<double> weights_;     // workspace (n)
  std::vector<double> own_;         // error of each unknown that is no image of inputs' (n)
  std::vector<double> trial_;       // radii of X (n)
  std::vector<double> contracted_;  // bound on |(I − Y Φ_φ(X)) X| (n)
};

}  // namespace desmo
