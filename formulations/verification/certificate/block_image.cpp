#include <algorithm>
#include <cmath>

#include "formulations/verification/certificate/block_proof.h"
#include "formulations/verification/certificate/trial_box.h"

namespace desmo {

// Rounding. The errors of the unknowns are at most b + A X, where A = |I − Y Φ_φ|. find_image()
// finds b, and contract() finds A X. They add `rounding` times P and Q:
//
//   P = |Y| |Φ_φ| X
//   Q = |Y| (|Φ_h| |δ| + the magnitudes of the lower terms, which only rates have)
//
// This covers the following, in units of roundoff, for a block of w columns, n of them unknowns,
// and K symbols:
//
// - Y Φ_φ and Y Φ_h: n (X + P) and n Q. Each entry takes n roundings.
// - centres and symbols: (3 w + 2) (P + 2 Q). They take 3 w + 2 roundings from Φ on, and
//   |Φ| ≤ |Φ_φ| X + |Φ_h| |δ| + … where b + A X ≤ X.
// - constant entries of Φ_q: P and Q, as if each entry were rounded once
// - bounds: (3 w + K + 6) X. They are sums of positive products, with 3 w + K + 6 roundings or
// less.
//
// For rates, X stands for the vector that bound_rates() multiplies A with. A proof requires
// A X ≤ X/2. Since X ≤ A X + P, X is at most 2 P. The sum of all is then at most
// (12 w + 2 K + 15) P + (7 w + 5) Q, and `rounding` is 32 (w + K) units.

/// Finds b, the part of the errors that X does not cause: −Y Φ − Y Φ_h δ, and for rates −Y times
/// the lower terms.
template <int N>
void BlockProof::find_image(Level level) {
  const BlockShape& s = *shape_;
  const LaneMatrix& jacobian = batch_->jacobian;
  const int n = N > 0 ? N : s.unknowns, m = s.inputs;
  const LaneNumbers rounding = batch_->rounding;
  ErrorColumns& e = errors_[level];
  for (int r = 0; r < n; ++r) {
    const LaneInterval& f = phi_[level][r];
    LaneNumbers centre = f.mid, uncertain = f.radius;
    const int row_end = s.row_begins[r + 1];
    for (int k = s.input_begins[r]; k < row_end; ++k) {
      const int j = s.entries[k];
      const LaneNumbers mid = jacobian.mid[k];
      centre = fma(mid, e.centre[j], centre);
      uncertain = fma(fma(rounding, abs(mid), jacobian.radius[k]), e.sum[j], uncertain);
    }
    for (const LowerTerm& term : lower_) {
      const ErrorColumns& lower = errors_[term.errors];
      const LaneMatrix& derivative = rates_[term.derivative];
      LaneNumbers of_centre(0), of_own(0);
      for (int k = s.row_begins[r]; k < row_end; ++k) {
        const int j = s.entries[k];
        const LaneNumbers mid = derivative.mid[k];
        of_centre = fma(mid, lower.centre[j], of_centre);
        of_own = fma(abs(mid), lower.weight[j], of_own);
        of_own = fma(derivative.radius[k], lower.sum[j], of_own);
      }
      centre = fma(of_centre, term.factor, centre);
      uncertain = fma(of_own, term.factor, uncertain);
    }
    centre_[r] = centre;
    uncertainty_[r] = uncertain;
  }
  for (int i = 0; i < n; ++i) {
    const LaneNumbers *y = &y_->inverse[i * n], *slopes = y_->slopes.data() + i * m;
    LaneNumbers centre(0), own(0);  // own ends > 0, as radii of Φ are
    for (int r = 0; r < n; ++r) {
      centre = fma(-y[r], centre_[r], centre);
      own = fma(abs(y[r]), uncertainty_[r], own);
    }
    for (int j = 0; j < m; ++j) own = fma(slopes[j], e.own[n + j], own);
    e.centre[i] = centre;
    e.own[i] = own;
    e.sum[i] = abs(centre) + own;
  }
}

/// Finds the symbols of the unknowns in the same way. The batch has a single block.
void BlockProof::find_generators(Level level, PerLevel<ErrorTable>& errors) {
  const BlockShape& s = *shape_;
  const std::vector<int>& rows = batch_->rows;
  ErrorTable& to = errors[level];
  const int n = s.unknowns, columns = to.columns;
  std::fill_n(generators_.begin(), n * columns, 0);
  const auto add = [&](const LaneMatrix& derivative, double factor, bool inputs, Level from) {
    for (int r = 0; r < n; ++r)
      for (int e = inputs ? s.input_begins[r] : s.row_begins[r]; e < s.row_begins[r + 1]; ++e) {
        const int row = rows[LaneNumbers::count * s.entries[e]];
        const double t = factor * derivative.mid[e][0];
        if (t == 0 || !errors[from].has_generators(row)) continue;
        const double* image = errors[from].of_row(row);
        double* generators = &generators_[r * columns];
#pragma omp simd
        for (int k = 0; k < columns; ++k) generators[k] += t * image[k];
      }
  };
  add(batch_->jacobian, 1, true, level);
  for (const LowerTerm& t : lower_) add(rates_[t.derivative], t.factor, false, t.errors);
  for (int i = 0; i < n; ++i) {
    double* generators = to.of_row(rows[LaneNumbers::count * i]);
    std::fill_n(generators, columns, 0);
    for (int r = 0; r < n; ++r) {
      const double y = y_->inverse[i * n + r][0];
#pragma omp simd
      for (int k = 0; k < columns; ++k) generators[k] -= y * generators_[r * columns + k];
    }
    double sum = 0;
#pragma omp simd reduction(+ : sum)
    for (int k = 0; k < columns; ++k) sum += std::abs(generators[k]);
    errors_[level].sum[i] += sum;
  }
}

void BlockProof::find_image(Level level, PerLevel<ErrorTable>& errors) {
  with_unrolled_size(shape_->unknowns, [&]<int N>() { find_image<N>(level); });
  if (errors[level].columns > 0) find_generators(level, errors);
}

void contract(const BlockBatch& b, const Preconditioner& y, const LaneNumbers* trial,
              LaneNumbers* uncertainty, LaneNumbers* contracted) {
  const BlockShape& s = b.equations.shape();
  const LaneMatrix& jacobian = b.jacobian;
  const LaneNumbers rounding = b.rounding;
  with_unrolled_size(s.unknowns, [&]<int N>() {
    const int n = N > 0 ? N : s.unknowns;
    for (int r = 0; r < n; ++r) {
      LaneNumbers sum(0);
      for (int e = s.row_begins[r]; e < s.input_begins[r]; ++e)
        sum =
            fma(fma(rounding, abs(jacobian.mid[e]), jacobian.radius[e]), trial[s.entries[e]], sum);
      uncertainty[r] = sum;
    }
    for (int i = 0; i < n; ++i) {
      LaneNumbers sum(0);
      for (int r = 0; r < n; ++r) {
        sum = fma(y.remainder[i * n + r], trial[r], sum);
        sum = fma(abs(y.inverse[i * n + r]), uncertainty[r], sum);
      }
      contracted[i] = sum;
    }
  });
}

}  // namespace desmo
