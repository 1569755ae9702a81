#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/parts/explicit_part.h"
#include "formulations/scaling/length_powers.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// A part in explicit order whose lengths are so far from 1 that products of many of them, which
/// closed forms have, would over- or underflow. They are written in a unit of its own, a power of
/// two, which rounds nothing; what is refused even so is left to `fallback` in the unit of all.
class OwnUnitPart final : public GuardedPart {
 public:
  /// The unit, and the powers of it in each constraint of the part.
  struct Unit {
    int exponent;  ///< binary orders by which a length is smaller in it
    std::vector<LengthPowers> powers;
  };
  /// magnitudes: of the part's unknowns. Nothing where lengths are near enough to 1.
  static std::optional<Unit> find_unit(const Model& model, const PartDefinition& part,
                                       std::span<const double> magnitudes);

  /// The others are those of ExplicitPart.
  OwnUnitPart(const Model& model, const PartDefinition& part, const Unit& unit,
              const ExplicitKernel& kernel, const BoundKernel& bound,
              std::span<const double> weights, const Settings& settings,
              std::unique_ptr<Part> fallback);

  PartResult solve(State& state, std::span<const double> last, Level level) override;
  PartInputs inputs(PartInputs equations) const override;
  void forget() override { part_->forget(); }
  void end_assembly() override { part_->end_assembly(); }
  long fallbacks() const override { return part_->fallbacks(); }
  long branch_changes() const override { return part_->branch_changes(); }

 private:
  class InUnitOfAll;
  std::vector<int> in_state(std::vector<int> own) const;
  void take(const State& all);
  void give(State& all) const;

  std::vector<int> inputs_;    // in the state of all, of each of its own
  std::vector<double> share_;  // of each, own over that of all
  std::vector<int> unknowns_;  // of its own inputs
  State own_;
  std::vector<double> own_last_;  // positions of its unknowns
  State* all_ = nullptr;          // while it is being solved
  std::span<const double> last_;  // the same
  std::unique_ptr<ExplicitPart> part_;
};

}  // namespace desmo
