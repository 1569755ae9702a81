#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/equations/explicit_kernel.h"
#include "formulations/equations/symbolic.h"

namespace desmo {

/// A group or block solved by generated code in explicit order. `fallback` finds the first position
/// after forget() from the last positions, iterating on the original equations. The signs of the
/// square roots there are the assembly branch, which later steps keep. The code refuses a step
/// where a root or a divisor is too small or the original equations are not satisfied. The step is
/// then tried again with torn unknowns continued from the last position: at the prediction a square
/// root may have no value. If it is refused again, `fallback` solves it from the last position, and
/// the branches are those of its solution.
class ExplicitPart final : public Part {
 public:
  /// bound: inputs and dimensions of the part; `kernel` takes the same in the same order. weights:
  /// 1/magnitude of each equation (see magnitudes.h).
  ExplicitPart(const ExplicitKernel& kernel, const BoundKernel& bound,
               std::span<const double> weights, const PartSettings& settings,
               std::unique_ptr<Part> fallback);

  PartResult solve(State& state, std::span<const double> last, Level level) override;
  /// Returns the torn unknowns as the predicted ones: those in closed form need no prediction. The
  /// first solution after forget() starts from the last positions and needs none at all.
  PartInputs inputs(PartInputs equations) const override;
  /// Makes a chain of parts that share the kernel.
  std::unique_ptr<PartChain> make_chain(std::span<Part* const> parts) override;
  void forget() override;

  PartCounts counts() const override {
    return {
        .refactorisations = fallbacks_, .fallbacks = fallbacks_, .branch_changes = branch_changes_};
  }
  /// Returns whether a position was found since forget(), so that the kernel may go on from it.
  bool assembled() const { return assembled_; }
  const ExplicitKernel& kernel() const { return kernel_; }
  const ExplicitBinding<double>& binding() const { return binding_; }
  /// Returns the positions in the state that the kernel reads or writes.
  std::span<const int> places() const { return inputs_; }
  std::size_t constants() const { return constants_; }  ///< number of dimensions
  std::size_t equations() const { return equations_; }  ///< number of equations
  /// Returns the branches kept: the sign of each square root, ±1, in the order of
  /// ExplicitKernel::branches; 0 before any position.
  std::span<const double> branches() const { return {branch_, kernel_.branches.size()}; }

 private:
  std::vector<int> in_state(std::span<const int> inputs) const;
  ExplicitChainResult solve_generated(State& state, Level level) const;
  bool continue_torn(State& state, std::span<const double> last, int steps);
  PartResult solve_refused(State& state, std::span<const double> last, Level level);
  PartResult fall_back(State& state, std::span<const double> last, Level level);

  const ExplicitKernel& kernel_;
  ExplicitBinding<double> binding_;
  bool assembled_ = false;
  long fallbacks_ = 0, branch_changes_ = 0;
  std::unique_ptr<Part> fallback_;
  double tolerance_;
  std::vector<int> inputs_;
  std::vector<int> known_;  // positions in the state of inputs that are not unknowns
  struct Known {
    double q, qd;
  };
  std::vector<Known> at_end_;  // values of known_ at the end of the step, kept by continue_torn()
  std::size_t constants_, equations_;
  std::vector<double> numbers_;      // arrays of binding_ except `in`, and branch_before_
  double *branch_, *branch_before_;  // branches now, and before a fallback
  std::span<double> anchors_;
};

}  // namespace desmo
