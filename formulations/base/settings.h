#pragma once

#include "cases/mechanism/scene.h"

namespace desmo {

/// The prediction from which Newton–Raphson starts in a step (see formulations/prediction/guess.h).
enum class Guess {
  previous,   ///< q of the last instant
  linear,     ///< its tangent, from q̇
  quadratic,  ///< Taylor, from q̇ and q̈
  hermite3,   ///< the cubic through q and q̇ of the last two instants
  hermite5,   ///< the quintic through their q, q̇ and q̈
  adams8,     ///< from the last q, the polynomial through q̇ and q̈ of the last four
};

/// When Φ_φ is factorised (see formulations/parts/newton_solver.h).
enum class JacobianUpdate {
  newton,  ///< in every iteration, and at the solved position for velocity and acceleration
  step,    ///< at the solved position, for velocity, acceleration and the next step's iterations
  chord,   ///< when the factors at hand, several steps old, have become too slow
};

/// Floating-point numbers that the analysis uses.
enum class Scalar {
  double_precision,
  single_precision,  ///< the state, the equations and the linear systems
  mixed,             ///< the factors alone are single; what is solved with them is refined
};

/// Levels that a factorisation at the solved position serves.
enum class Factorisation {
  shared,     ///< velocity and acceleration
  per_level,  ///< one of them: each level makes its own
};

/// Permutation of a matrix to block triangular form by KLU, before it factorises the blocks.
enum class BlockTriangularForm { on, off };

inline constexpr int max_stride = 64;
inline constexpr int max_threads = 64;

/// Settings of an analysis, as in Settings{.guess = Guess::hermite5, .lanes = 4}. The defaults are
/// the paper's. Not every formulation offers every combination (see unsupported_reason in
/// formulations/variants.h).
struct Settings {
  /// Bound on ‖Φ‖₂ of the whole model, each equation divided by its natural magnitude (see
  /// formulations/scaling/magnitudes.h): relative, whatever the units are. The default asks of the
  /// paper's two cases what 1e-10 in metres and their squares does.
  double tolerance = default_tolerance;
  int max_iterations = 25;  ///< of Newton–Raphson, a step
  Guess guess = Guess::previous;
  /// 0: iterate until the tolerance is met. Otherwise exactly this number of iterations a step,
  /// whatever ‖Φ‖₂ is, so that a step's work does not depend on rounding; an assembly repeats them
  /// until the tolerance is met or max_iterations times.
  int fixed_iterations = 0;
  JacobianUpdate jacobian = JacobianUpdate::newton;
  Factorisation factorisation = Factorisation::shared;
  BlockTriangularForm btf = BlockTriangularForm::on;  ///< of KLU alone
  Scalar scalar = Scalar::double_precision;
  /// Equal subsystems, or parts of one type, that are solved at once in a batch, on wide registers,
  /// by variants that have code for it: up to 4 or, where the processor has AVX-512, 8. 1: no
  /// batches.
  int lanes = 1;
  /// Segments of a motion known in advance that are solved at once on wide registers, by variants
  /// that have code for it: 4 or 8, as lanes. 1: it is solved step by step.
  int segments = 1;
  /// Segments of a motion known in advance that are solved on as many threads at once, 1 …
  /// max_threads; fewer where there is little to do. 1: all is done on the caller's thread.
  int threads = 1;
  /// Solves every stride-th instant of a motion known in advance, and the last one, and
  /// interpolates the others (see formulations/stepping/dense_output.h), 2 … max_stride. 1: solves
  /// all, as it does when instants are asked for one at a time.
  int stride = 1;
};

/// Settings of one part, with the tolerance on its own equations.
struct PartSettings : Settings {
  PartSettings(const Settings& settings) : Settings(settings) {}

  /// The tolerance is not one that was asked for but what rounding leaves: once below it, Newton's
  /// method makes one correction more, which takes it as far as rounding lets it.
  bool at_rounding = false;
};

}  // namespace desmo
