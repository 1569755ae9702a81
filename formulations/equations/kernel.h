#pragma once

#include <span>
#include <string_view>

namespace desmo {

/// Partial derivative ∂Φ_row/∂input that a kernel emits; input is a local input.
struct KernelEntry {
  int row, input;
};

/// Result of a generated Newton iteration.
struct InlinedResult {
  int iterations;
  double residual2;  ///< ‖Φ‖₂², each equation times its weight
};

/// Generated straight-line code for one type of group (see PartType). Its arguments:
/// - state, rate, acc: q, q̇ and q̈, each followed by the components of fixed entities
/// - in[i]: position of local input i in them
/// - c: dimensions
/// - slot[e]: position of entry e in `values`; constant entries first, then dependent, then known
struct Kernel {
  std::string_view name;         ///< name of the group where it was first met
  std::string_view fingerprint;  ///< PartType::fingerprint
  int rows;
  std::span<const KernelEntry> constant_entries;   ///< entries of Φ_q that never change
  std::span<const KernelEntry> dependent_entries;  ///< entries of Φ_φ, by the group's unknowns
  std::span<const KernelEntry> known_entries;      ///< entries of Φ_h, by known coordinates

  void (*constant)(const double* c, const int* slot, double* values);
  void (*residual)(const double* state, const int* in, const double* c, double* phi);
  void (*dependent)(const double* state, const int* in, const double* c, const int* slot,
                    double* values);
  void (*known)(const double* state, const int* in, const double* c, const int* slot,
                double* values);
  void (*quadratic)(const double* state, const double* rate, const int* in, const double* c,
                    double* gamma);

  /// Iterates Newton–Raphson with the elimination inlined, until ‖Φ‖₂² < tolerance2 or NaN, up to
  /// max_iterations times in each pivot order. Each order starts from the unknowns in `state`,
  /// which the last one tried overwrites. With tolerance2 = 0 the first order alone makes
  /// max_iterations. Each equation is multiplied by its weight (1/magnitude). A bad pivot shows in
  /// the residual of the original equations.
  InlinedResult (*position)(double* state, const int* in, const double* c, const double* weight,
                            double tolerance2, int max_iterations);
  /// Solves velocities and, when acc is not null, accelerations of the unknowns at a solved
  /// position. Returns false, with unusable results, when a pivot was too small compared with its
  /// column (PivotMonitor).
  bool (*rates)(const double* state, double* rate, double* acc, const int* in, const double* c);
};

}  // namespace desmo
