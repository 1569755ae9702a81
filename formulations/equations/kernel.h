#pragma once

#include <span>
#include <string_view>

namespace desmo {

/// A partial derivative ∂Φ_row/∂input that a kernel emits, over its local inputs.
struct KernelEntry {
  int row, input;
};

/// Where a generated Newton iteration stopped.
struct InlinedResult {
  int iterations;
  double residual2;  ///< ‖Φ‖₂², each equation times its weight
};

/// Generated straight-line code for one type of group (see PartType). `state`, `rate`, `acc` are
/// q, q̇, q̈ with fixed entities behind, `in[i]` the position of local input i in them, `c` the
/// dimensions, `slot[e]` the place in `values` of entry e: constant ones first, then dependent,
/// then known.
struct Kernel {
  std::string_view name;         ///< of the group it was first seen in
  std::string_view fingerprint;  ///< PartType::fingerprint
  int rows;
  std::span<const KernelEntry> constant_entries;   ///< of Φ_q that never change
  std::span<const KernelEntry> dependent_entries;  ///< of Φ_φ, the group's own unknowns
  std::span<const KernelEntry> known_entries;      ///< of Φ_h, what the group takes as known

  void (*constant)(const double* c, const int* slot, double* values);
  void (*residual)(const double* state, const int* in, const double* c, double* phi);
  void (*dependent)(const double* state, const int* in, const double* c, const int* slot,
                    double* values);
  void (*known)(const double* state, const int* in, const double* c, const int* slot,
                double* values);
  void (*quadratic)(const double* state, const double* rate, const int* in, const double* c,
                    double* gamma);

  /// Newton–Raphson with the elimination inlined, until ‖Φ‖₂² < tolerance2 or no longer a number,
  /// where each equation is multiplied by its weight (1/magnitude).
  /// A pivot gone bad shows in the residual of the original equations.
  InlinedResult (*position)(double* state, const int* in, const double* c, const double* weight,
                            double tolerance2, int max_iterations);
  /// Velocities and (when acc is not null) accelerations of the unknowns at a solved position;
  /// false, and nothing usable, when a pivot was too small beside its column (PivotMonitor).
  bool (*rates)(const double* state, double* rate, double* acc, const int* in, const double* c);
};

}  // namespace desmo
