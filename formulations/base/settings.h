#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include "cases/mechanism/scene.h"

namespace desmo {

/// Ways to cut the unknowns into parts that are solved one after the other.
enum class Partition {
  global,  ///< one part: all structural groups at once
  group,   ///< one part per structural group
  block,   ///< one part per irreducible block of a group's equations
};

/// Ways to evaluate the equations.
enum class Evaluation {
  automatic,  ///< a loop over constraint objects
  symbolic,   ///< generated straight-line code
};

/// The prediction from which Newton–Raphson starts in a step.
enum class Guess {
  previous,   ///< q of the last instant
  linear,     ///< Taylor to first order, from q and q̇ of the last instant
  quadratic,  ///< Taylor to second order, from q, q̇ and q̈ of the last instant
  hermite3,   ///< the cubic through q and q̇ of the last two instants
  hermite5,   ///< the quintic through q, q̇ and q̈ of the last two instants
  /// The last q plus the integral of the polynomial through q̇ and q̈ of the last four instants.
  adams8,
};

/// When Φ_φ, the Jacobian of a part by its unknowns, is factorised. Positions are accepted by the
/// tolerance alone, whatever the factors. Velocities and accelerations use the factors at the
/// solved position.
enum class JacobianUpdate {
  newton,  ///< in every iteration and, for rates, at the solved position
  step,    ///< for rates, at the solved position; iterations of the next step use these factors
};

/// Coordinates in which a mechanism is modelled. Every model has the points, vectors and relative
/// coordinates of the mechanism under the same names. A derived coordinate follows from others by
/// an explicit equation.
enum class Modelling {
  natural,    ///< no others, none derived: the paper's natural and mixed coordinates
  basis,      ///< no others; points and vectors that are linear in a body's basis are derived
  reference,  ///< also position and orientation of each body, from which points and vectors follow
  relative,   ///< also joint variables of a spanning tree, from which points and vectors follow
};
inline constexpr std::array modelling_kinds{Modelling::natural, Modelling::basis,
                                            Modelling::reference, Modelling::relative};
/// Names in ids and on command lines, in the order of modelling_kinds.
inline constexpr std::array<std::string_view, 4> modelling_names{"natural", "basis", "reference",
                                                                 "relative"};

/// Returns the name of a modelling in ids and on command lines.
constexpr std::string_view name_of(Modelling modelling) {
  return modelling_names[static_cast<std::size_t>(modelling)];
}

/// Returns whether each body has a frame (origin and axes), from which its points and vectors are
/// derived.
constexpr bool has_frames(Modelling modelling) {
  return modelling == Modelling::reference || modelling == Modelling::relative;
}

/// Evaluation of derived unknowns, such as those of a body's frame, in Newton's method. Their rates
/// follow from linear systems in any case.
enum class Frames {
  linearised,  ///< the linear system of an iteration corrects derived unknowns, too
  exact,  ///< in steps, an iteration corrects the others, then evaluates the derived ones from them
};

/// Permutation of a matrix to block triangular form by KLU, before it factorises the blocks.
enum class BlockTriangularForm { on, off };

/// Maximum values (≤) of Settings::stride [instants], Settings::threads and
/// Settings::fixed_iterations.
inline constexpr int max_stride = 64;
inline constexpr int max_threads = 64;
inline constexpr int max_fixed_iterations = 1000;

/// Settings of an analysis, as in Settings{.guess = Guess::hermite5, .lanes = 4}. The defaults are
/// the paper's. Not every formulation offers every combination (see unsupported_reason()).
struct Settings {
  /// Limit of ‖Φ‖₂ of the whole model (<), positive. Each equation is divided by its natural
  /// magnitude (Magnitudes), such as the length of nearby bodies for a difference of points. To
  /// first order ‖Φ‖₂ is then a relative error of position, whatever the units. Where rounding
  /// leaves more of a part's ‖Φ‖₂ than the part's share of the tolerance, its rounding floor
  /// counts.
  double tolerance = default_tolerance;
  /// Limit of Newton–Raphson iterations of one part in one attempt, 1 or more.
  int max_iterations = 25;
  Guess guess = Guess::previous;
  /// 0: iterate until the tolerance is met. 1 … max_fixed_iterations: this number of iterations of
  /// each part in a step, whatever ‖Φ‖₂ is. A step's work then does not depend on rounding. An
  /// assembly repeats them until the tolerance is met, at most max_iterations times more.
  int fixed_iterations = 0;
  JacobianUpdate jacobian = JacobianUpdate::newton;
  BlockTriangularForm btf = BlockTriangularForm::on;  ///< used by KLU alone
  /// Number of equal subsystems, or parts of one type, that a batch solves at once on wide
  /// registers: 4 or, where the processor has AVX-512, 8. 1: no batches. For `explicit` alone.
  int lanes = 1;
  /// Number of segments of a motion known in advance that are solved at once on wide registers, one
  /// in each lane: 4 or 8. 1: it is solved step by step. For `explicit` alone, without `lanes`.
  int segments = 1;
  /// Number of threads, 1 … max_threads, each of which solves a segment of a motion known in
  /// advance; short motions use fewer. 1: all is done on the caller's thread.
  int threads = 1;
  /// Stride of a run, 1 … max_stride: it solves every stride-th instant and the last. The others
  /// lie on the quintic through q, q̇ and q̈ of the two solved instants around them. 1: all are
  /// solved. step() and assemble() always solve; checked runs solve all instants after a jump or a
  /// gap.
  int stride = 1;
  Modelling coordinates = Modelling::natural;  ///< coordinates of the model that is solved
  Frames frames = Frames::linearised;          ///< for coordinates with frames (has_frames)
};

}  // namespace desmo
