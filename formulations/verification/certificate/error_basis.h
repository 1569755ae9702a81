#pragma once

#include <vector>

namespace desmo {

/// Errors that are known as a linear image of unit boxes: row i of a set of errors is
/// Σ G(i, k) t(k) with all |t(k)| ≤ 1.
struct Generators {
  const double* values;          ///< G, by rows
  int columns;                   ///< of each row
  const std::vector<int>& rows;  ///< the d rows that make up the set
};

/// A box in an orthonormal basis that encloses a set of d errors: error i = Σ Q(i, s) σ(s) t(s).
/// Boxes along coordinates would grow from block to block of a chain that turns (the wrapping
/// effect). A basis that turns along, its largest direction first, prevents it (Lohner,
/// Einschließung der Lösung gewöhnlicher Anfangs- und Randwertaufgaben, 1988).
class ErrorBasis {
 public:
  /// d: number of errors; columns: the most that generators will have.
  ErrorBasis(int d, int columns);

  int size() const { return d_; }
  /// Encloses a set of generators. Allocates nothing.
  void enclose(const Generators& generators);
  /// Encloses the box |error i| ≤ radii[rows[i]]; infinite ones count as 0.
  void enclose_box(const double* radii, const std::vector<int>& rows);
  /// Returns Q(i, s) σ(s).
  double generator(int i, int s) const { return q_[i * d_ + s] * sigma_[s]; }

 private:
  void find_directions(const Generators& generators);
  double deviation() const;

  int d_;
  std::vector<double> q_;      // (d × d) by rows
  std::vector<double> sigma_;  // (d)
  std::vector<double> rest_;   // (d × columns) by rows: what the directions so far leave
  std::vector<double> sums_;   // workspace (columns, at least d)
};

}  // namespace desmo
