#pragma once

#include <span>
#include <vector>

namespace desmo {

/// A box in an orthonormal basis that encloses a set of errors. The errors are linear images of
/// unit boxes: error i = Σ G(i, k) t(k) + own(i) w(i) with all |t(k)|, |w(i)| ≤ 1. The enclosure is
/// error i = Σ H(i, s) t'(s), with one new symbol for each error.
///
/// Boxes along the coordinates would grow exponentially from group to group of a chain that turns
/// (the wrapping effect). A basis that turns with the errors, the largest direction first, prevents
/// this (Lohner, Einschließung der Lösung gewöhnlicher Anfangs- und Randwertaufgaben, 1988).
class ErrorBasis {
 public:
  /// Allocates for sets of at most max_errors errors and max_columns columns of G.
  ErrorBasis(int max_errors, int max_columns);

  /// Begins a set of errors, all of which set() must then set. columns: number of columns of G.
  void start(int errors, int columns);
  /// Sets error i: its row of G (columns), and its own radius. The sum of own and the magnitudes of
  /// G(i, k) must be 0 or above 1e-300.
  void set(int i, const double* generators, double own);
  /// Encloses all errors. Allocates nothing.
  void enclose();

  /// Returns a bound on ‖I − QᵀQ‖∞ for a matrix Q (d × d, by rows) with nearly orthonormal columns.
  /// The bound also covers all other rounding of enclose(), relative to the box's widest radius.
  static double deviation(std::span<const double> q, int d);

  /// Returns the number of errors, which is also that of new symbols.
  int size() const { return size_; }
  /// Returns H(i, s), rounded once.
  double generator(int i, int s) const { return basis_[i * size_ + s] * radii_[s] / scale_[i]; }

 private:
  void find_directions();

  int size_ = 0, columns_ = 0;
  std::vector<double> generators_;  // G, each row times its scale (size × columns)
  std::vector<double> own_;         // own radius of each error times its scale (size)
  std::vector<double> scale_;       // power of two that brings an error > 0 to about 1 (size)
  std::vector<double> basis_;       // Q (size × size)
  std::vector<double> radii_;       // radii of the box in the basis (size)
  std::vector<double> rest_;        // workspace: scaled G less its parts along directions found
  std::vector<double> sums_;        // workspace (columns)
};

}  // namespace desmo
