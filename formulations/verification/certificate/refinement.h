#pragma once

#include <array>
#include <vector>

#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/certificate/lane_numbers.h"

namespace desmo {

/// An instant to which the corrections of its certificates were added.
struct RefinedInstant {
  Instant instant{};  ///< as it was where no certificate is proven
  bool proven = false;
  /// Bounds on |instant − exact| of each coordinate, at the levels of the instant alone.
  PerLevel<std::span<const double>> radius{};
  Certificate last{};  ///< of the last pass; of the last proven one, if any is
  int passes = 0;
};

/// Refinement of solved instants, whatever solved them: certifies one and adds the corrections,
/// again while Newton's method converges. One pass is the rule. All formulations then deliver the
/// same numbers but for the last digits.
///
///   Refinement refinement(model);
///   const RefinedInstant r = refinement.refine(instant);   // in an observer, for example
class Refinement {
 public:
  /// Passes to the first proof, and from it on. Digits double in each: six lead from one to 53
  /// bits, and two more to the first one.
  static constexpr int max_passes = 8;

  /// Contract of Certifier.
  explicit Refinement(const Model& model, std::span<const Level> levels = {});
  explicit Refinement(const Model&& model, std::span<const Level> levels = {}) = delete;

  /// Refines an instant of all coordinates, up to the levels that it has. The result is valid until
  /// the next call. Allocates nothing.
  const RefinedInstant& refine(const Instant& instant);

  const Certifier& certifier() const { return certifier_; }

 private:
  using Values = PerLevel<std::vector<double>>;
  /// Errors at a level.
  struct Digits {
    double before = 0;             ///< before the corrections: roundings of the largest number
    double open = 0;               ///< after them, likewise
    std::array<double, 2> rest{};  ///< after them, of each kind, in its unit
  };

  void add_corrections(const Certificate& certificate);
  PerLevel<Digits> digits(const Certificate& certificate) const;

  const Model& m_;
  Certifier certifier_;
  std::vector<LaneMask> lengths_;  // which of each four coordinates are lengths, not rotations
  std::span<const Level> levels_;  // of the present instant
  Values next_, radius_;           // with corrections of the last pass
  Values best_, best_radius_;
  RefinedInstant result_;
};

}  // namespace desmo
