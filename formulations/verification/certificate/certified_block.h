#pragma once

#include <span>
#include <vector>

#include "formulations/base/per_level.h"
#include "formulations/verification/certificate/interval_block.h"

namespace desmo {

/// Errors of what one structural group reads, and of its unknowns, at one level, row by row. Error
/// i is center(i) + Σ G(i, k) t(k) + own(i) w(i) with all |t(k)|, |w(i)| ≤ 1. Rows share the
/// symbols t, which come from earlier groups; levels share them, too.
struct ErrorRows {
  int columns = 0;
  std::vector<double> center, generators, own;  ///< (rows), (rows × columns), (rows)
  std::vector<double> sum;                      ///< |center(i)| + Σ |G(i, k)| + own(i), rounded up
  std::vector<double> radius;                   ///< bound on |error i|

  double* of_row(int row) { return generators.data() + row * columns; }
  const double* of_row(int row) const { return generators.data() + row * columns; }
};

/// Intervals of whole states (Model::state_size()).
using IntervalState = PerLevel<std::vector<Interval>>;

/// An irreducible block, and what Krawczyk's test of it needs.
class CertifiedBlock {
 public:
  /// rows: those of the n unknowns, then of the m inputs, in ErrorRows. magnitudes: of the
  /// unknowns; errors of 1e-18 of these do not matter.
  CertifiedBlock(IntervalBlock equations, std::vector<int> rows, int columns,
                 std::vector<double> magnitudes);

  const IntervalBlock& equations() const { return equations_; }
  std::span<const int> unknown_rows() const { return std::span(rows_).first(size()); }
  std::span<const int> input_rows() const { return std::span(rows_).subspan(size()); }

  /// Evaluates the equations of delivered numbers, up to a level. Comes before the other functions.
  void evaluate(const IntervalState& delivered, Level level);
  /// Proves a solution near the delivered positions. state: these with radii, of which those of the
  /// inputs are known. Writes the unknowns' rows and radii. Returns false where no proof succeeds;
  /// both are unspecified then.
  bool prove_positions(IntervalState& state, PerLevel<ErrorRows>& errors);
  /// Bounds velocities or accelerations in the same way, after all lower levels.
  bool bound_rates(Level level, const IntervalState& delivered, IntervalState& state,
                   PerLevel<ErrorRows>& errors);

 private:
  /// Errors of the block's rows at one level, side by side: unknowns, then inputs, then zeros.
  /// Errors of unknowns are zero while they are not known.
  struct Errors {
    std::vector<double> center, own, sum, radius;
  };

  int size() const { return equations_.size(); }
  int stride() const { return 4 * quads_; }
  void gather_inputs(Level level, const ErrorRows& from);
  // N is the size of the block where it is small, for the compiler to unroll loops; else 0.
  template <int N>
  int n() const {
    return N > 0 ? N : size();
  }
  template <class Function>
  auto with_size(Function&& function);
  template <int N>
  bool prove(IntervalState& state, PerLevel<ErrorRows>& errors);
  template <int N>
  bool bound(Level level, const IntervalState& delivered, IntervalState& state,
             PerLevel<ErrorRows>& errors);
  template <int N>
  bool invert();
  template <int N>
  void find_remainder();
  template <int N>
  void find_slopes(const IntervalMatrix& derivative, std::vector<double>& slopes) const;
  template <int N>
  void start(Level level, ErrorRows& to);
  template <int N>
  void add_image(Level derivative, double factor, Level level, const PerLevel<ErrorRows>& from,
                 ErrorRows& to);
  template <int N>
  void add_uncertainty(ErrorRows& to);
  template <int N>
  void find_image(PerLevel<ErrorRows>& errors);
  template <int N>
  void contract();
  void add_own(ErrorRows& to, int i, double radius) const;
  template <int N>
  bool finish(Level level, IntervalState& state, ErrorRows& errors);

  IntervalBlock equations_;
  std::vector<int> rows_;
  std::vector<double> magnitudes_;
  int quads_;                             // quarter of the length of matrix rows
  double rounding_;                       // bound on the relative rounding of all sums of products
  bool inverted_ = false;                 // what is constant is known
  PerLevel<IntervalMatrix> jacobian_;     // Φ_q, Φ̇_q, Φ̈_q (n × (n + m))
  PerLevel<std::vector<double>> slopes_;  // −Y times their midpoints
  std::vector<double> inverse_;           // Y (n × n)
  std::vector<double> remainder_;  // |I − Y Φ_φ| at the delivered values; workspace (n × n)
  PerLevel<std::vector<Interval>> phi_;  // Φ, Φ̇, Φ̈ of the delivered values (n)
  PerLevel<Errors> near_;                // errors of the block's rows
  std::vector<double> weights_;          // uncertainty of each equation, and workspace (n)
  std::vector<double> trial_;            // radii of X (n)
  std::vector<double> contracted_;       // bound on |(I − Y Φ_φ(X)) X| (n)
};

}  // namespace desmo
