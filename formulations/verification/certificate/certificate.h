#pragma once

#include <memory>
#include <span>

#include "formulations/base/live_row.h"
#include "formulations/base/observer.h"
#include "formulations/base/per_level.h"
#include "formulations/model/model.h"

namespace desmo {

/// Reason why a block has no proof.
enum class ProofFailure {
  none,
  singular,  ///< the position is too near a singular one
  drivers,   ///< known errors of the inputs are too large: as a rule rounding of driver values
  time,      ///< radii of the inputs are too large or infinite: as a rule those of the motions
  origin,    ///< rounding of coordinates is too large, so far from the origin
  sizes,     ///< rounding is too large, with lengths or rates of so different sizes
  far_off,   ///< the delivered numbers are off by more than their rounding, too much for a proof
};

/// Sets that enclose the errors which a group of a long chain hands to the next.
enum class ErrorSets {
  boxes,  ///< boxes along the coordinates; where these prove nothing, bases are tried
  bases,  ///< boxes in orthonormal bases, which turn with the errors; at twice the price
};

struct BlockSchedule;

/// Proof about one instant. If `proven` is true, Φ(q, t) = 0 has exactly one solution within the
/// radii around the delivered positions. The rates of that solution are within the radii around the
/// delivered rates. Numbers of the file and the instant's time count as exact; dimensions are those
/// derived from them (Constraint::constants). Whether that solution lies on the branch that is
/// meant is not part of the proof.
struct Certificate {
  bool proven = false;
  /// Structural group of the first irreducible block, in solution order, without a proof;
  /// no_position where all are proven.
  GroupId group = no_position;
  ProofFailure failure = ProofFailure::none;  ///< of that block
  /// Condition number of the worst block at the delivered position, 1 or more. It is like
  /// ConditionNumber (condition.h), but of the block alone, and with characteristic lengths in
  /// place of the mechanism's size. Row sums count the columns of inputs, too. Infinite if a matrix
  /// is singular in doubles, or `failure` is `singular`. Leaves out blocks whose inputs have
  /// unbounded errors. Rounded, and no bound.
  double condition = 1;
  GroupId worst_conditioned = no_position;  ///< structural group of that block
  /// Bound on |delivered − exact| of each coordinate, in its own unit: no rounding is neglected.
  /// Infinite where no proof succeeded, in what depends on such a block, and at levels that the
  /// instant does not have. The exact value of a driven coordinate is that of its motion, or the
  /// one handed in. Valid until the next certify().
  PerLevel<std::span<const double>> radius{};
  /// Newton's correction of each coordinate in compensated arithmetic, and a bound on
  /// |delivered + correction − exact|, infinite where `radius` is. A block without a proof has a
  /// correction, too, if the errors of its inputs are bounded; else its correction is 0.
  PerLevel<std::span<const double>> correction{}, rest{};
};

/// Prover of radii of solved instants, whichever formulation solved them. It verifies the blocks of
/// the equations in solution order, each by Krawczyk's test about the delivered values. φ are the
/// block's unknowns, h its inputs with known errors δ. With an approximate inverse Y of Φ_φ and a
/// trial box X,
///
///   −Y Φ − Y Φ_h δ + (I − Y Φ_φ(X)) X  inside X
///
/// proves a solution in the left side, and no other in X (Krawczyk, Computing 4, 1969; Neumaier,
/// Interval Methods for Systems of Equations, 5.1). Velocities and accelerations are linear: the
/// contraction of the same test bounds their errors. Φ and its rates are evaluated in compensated
/// arithmetic, so that radii are hardly larger than the errors. Equal blocks share registers.
///
/// Each term enters at one place:
/// - Φ and its rates: BlockEquations::motion(); midpoint and radius go into find_image()
/// - Φ_φ and Φ_h within X and δ, and their rates: BlockEquations::jacobian(), jacobian_rates()
/// - errors of drivers: Certifier::Proof::take()
/// - differences of dimensions and fixed values from the file's: BlockEquations, LinearEquations
/// - bounds on the error of rows of Φ (Constraint::slack): BlockEquations::motion()
/// - errors δ of earlier blocks: BlockProof::gather(); centres and radii go through Y Φ_h in
///   find_image(), symbols in find_generators()
/// - errors of lower levels, which rates depend on: BlockProof::bound_rates()
/// - inflation of X, and the limit of its contraction: BlockProof::prove_positions()
/// - (I − Y Φ_φ(X)) X: contract() (trial_box.h); BlockProof::finish() adds it
/// - rounding: `rounding`, counted at the top of block_image.cpp
/// - change of basis: where boxes grow, GroupInterface encloses the errors that later groups of a
///   long chain read, in an orthonormal basis that turns with them (ErrorBasis)
///
///   Certifier certifier(model);
///   const Certificate c = certifier.certify(instant);   // in an observer, for example
///   if (c.proven) std::cout << c.radius.position[i];    // |q[i] − exact| is not larger
///
/// An instant costs about as much as a step of `global_automatic_klu`, in a long chain three to
/// four, in bases six. One thread at a time may use a certifier.
class Certifier {
 public:
  /// Cuts the model into blocks and allocates everything. levels: the level up to which each
  /// coordinate is solved (Plan::levels); empty: up to that of the instant. The memory of both must
  /// last as long as the certifier. In a homotopy (Constraint::initial_residual) the time of an
  /// instant is the parameter.
  explicit Certifier(const Model& model, std::span<const Level> levels = {});
  explicit Certifier(const Model&& model, std::span<const Level> levels = {}) = delete;
  ~Certifier();

  /// Certifies an instant of all coordinates, up to the levels that it has, with the motions of the
  /// model at its time. Allocates nothing.
  Certificate certify(const Instant& instant, ErrorSets sets = ErrorSets::boxes);
  /// Certifies an instant with drivers that were handed in, which count as exact.
  Certificate certify(const Instant& instant, const LiveRow& drivers);

  /// Returns whether the model has chains so long that ErrorSets::bases may bound errors better.
  bool has_long_chains() const;
  /// Returns the blocks of the model, whose memory a PathProof shares.
  const std::shared_ptr<BlockSchedule>& schedule() const;

 private:
  class Proof;
  std::unique_ptr<Proof> proof_;
};

}  // namespace desmo
