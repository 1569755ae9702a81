#pragma once

#include <array>
#include <vector>

#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// An instant to which the corrections of its certificates were added.
struct RefinedInstant {
  Instant instant{};  ///< with corrections; as it was given if no certificate is proven
  bool proven = false;
  /// Bounds on |instant − exact| of each coordinate, at the levels of the instant alone. Infinite
  /// without a proof.
  PerLevel<std::span<const double>> radius{};
  /// Certificate of the last proven pass or, if none is proven, of the last pass. Its spans view
  /// memory of the certifier. They hold what the last pass has found, proven or not.
  Certificate last{};
  int passes = 0;  ///< number of certificates
};

/// Refinement of solved instants, whatever solved them. It certifies an instant and adds the
/// corrections, and repeats this while Newton's method converges. One pass is the rule. All
/// formulations then deliver the same numbers but for the last digits.
///
///   Refinement refinement(model);
///   const RefinedInstant r = refinement.refine(instant);   // in an observer, for example
class Refinement {
 public:
  /// Maximum number of passes up to the first proven one, and again from that one on. Correct bits
  /// double in each pass: six lead from one bit to 53. Two more may be needed to the first bit.
  static constexpr int max_passes = 8;

  /// Takes the same arguments as Certifier, with the same lifetimes.
  explicit Refinement(const Model& model, std::span<const Level> levels = {});
  explicit Refinement(const Model&& model, std::span<const Level> levels = {}) = delete;

  /// Refines all coordinates of an instant, up to the levels that it has. The result is valid until
  /// the next call; an unproven one views the instant's numbers. Allocates nothing.
  const RefinedInstant& refine(const Instant& instant);

  const Certifier& certifier() const { return certifier_; }

 private:
  using Values = PerLevel<std::vector<double>>;
  /// Bounds on the errors at a level. There are two kinds of coordinates: 0, lengths; 1, rotations.
  struct Digits {
    double before = 0;             ///< before the corrections, over u × the kind's largest number
    double open = 0;               ///< after the corrections, over the same
    std::array<double, 2> rest{};  ///< after the corrections, of each kind, in its unit
  };

  void add_corrections(const Certificate& certificate);
  PerLevel<Digits> digits(const Certificate& certificate) const;

  const Model& m_;
  Certifier certifier_;
  std::vector<LaneMask> lengths_;  // lanes of each four coordinates that are no rotations
  std::span<const Level> levels_;  // of the present instant
  Values next_, radius_;           // numbers with the corrections of the last pass, their radii
  Values best_, best_radius_;      // these numbers and radii of the best pass at each level
  std::vector<double> unbounded_;  // radii without a proof
  RefinedInstant result_;
};

}  // namespace desmo
