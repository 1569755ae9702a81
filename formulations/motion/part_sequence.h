#pragma once

#include <algorithm>
#include <cmath>
#include <memory>
#include <span>
#include <vector>

#include "formulations/base/output.h"
#include "formulations/base/part.h"
#include "formulations/base/resident_part.h"
#include "formulations/model/partition.h"
#include "formulations/motion/prediction/guess.h"
#include "formulations/motion/prediction/motions_ahead.h"

namespace desmo {

/// The parts of a formulation in the order of solution: the constant ones, then the structural
/// groups or whatever else the unknowns were cut into. solve_moving() is the loop over groups of
/// the paper's Fig. 2a, inside the loop over instants (TimeStepping).
class PartSequence {
 public:
  /// The outcome of all parts in one step.
  struct Result {
    Status status = Status::solved;
    long iterations = 0;   ///< largest number of iterations of a part
    long updates = 0;      ///< iterations times unknowns, summed over parts
    double residual2 = 0;  ///< ‖Φ‖₂² of all parts up to the last one tried
    int failed = -1;       ///< position of the part that could not be solved; -1: none

    /// Adds the result of a part, or of several parts of a chain.
    void add(double part_residual2, long part_iterations, long part_updates) {
      residual2 += part_residual2;
      iterations = std::max(iterations, part_iterations);
      updates += part_updates;
    }

    /// Returns the summary of an instant at time t [s], without the group and constraint of a
    /// failure.
    Summary summary(double t) const {
      Summary summary;
      summary.status = status;
      summary.instants = summary.ok();
      summary.iterations = iterations;
      summary.updates = updates;
      summary.residual = std::sqrt(residual2);
      summary.time = t;
      return summary;
    }
  };

  /// The model outlives the sequence.
  PartSequence(const Model& model, std::vector<DefinedPart> parts);

  const std::vector<DefinedPart>& parts() const { return parts_; }

  /// Leaves out levels that nobody asks for (see Formulation::solve_only).
  void solve_only(std::span<const Level> needed);

  /// Solves the constant parts, or the moving ones, one after the other up to `level`; see
  /// Part::solve. Ends with the first part that cannot be solved.
  Result solve_constant(State& state, std::span<const double> last, Level level) const {
    return solve_in_order(constant_, state, last, level);
  }
  Result solve_moving(State& state, std::span<const double> last, Level level) const {
    return solve_in_order(moving_, state, last, level);
  }
  /// Solves positions of the moving parts, each by itself. Returns whether all could be solved.
  bool solve_positions(State& state, std::span<const double> last) const;

  /// Returns the driven coordinates that parts take from the driver row, in its order.
  std::span<const int> drivers() const { return drivers_; }

  /// Fixes where results go (see PartOutputs).
  /// - observed: on entry, whether each position in the state is read outside the parts; on return,
  ///   whether anybody reads it, a part or the prediction included
  /// - places: see PartOutputs::places
  void bind(std::vector<bool>& observed, std::span<int> places);
  /// Call the function of the same name of every moving part that is resident (ResidentPart).
  void begin_step(const StepHistory& history, const MotionRow& row);
  void deliver(const OutputView& output, Level level) const;
  void store(State& state) const;
  void restore(std::span<double> q) const;

  /// Makes every part forget its earlier steps (see Part::forget).
  void forget();
  /// Tells that the assembly is over (see Part::end_assembly).
  void end_assembly();

 private:
  /// A part as a step uses it; the elements stand next to each other in memory.
  struct PartInStep {
    Part* solver;
    Level level;                 // highest level to which it is solved
    int position, unknowns;      // position among all parts, number of unknowns
    PartChain* chain = nullptr;  // the chain that it belongs to; null: none
    int chain_position = 0;      // its position in the chain
  };
  struct Resident {
    ResidentPart* part;
    Level level;
    std::size_t first_driver;  // position of its first driver in the row
  };

  static Result solve_in_order(std::span<const PartInStep> parts, State& state,
                               std::span<const double> last, Level level);
  static std::span<const PartInStep> solve_chains(std::span<const PartInStep> parts, State& state,
                                                  Level level, Result& result);
  void order_parts();
  void make_chains();

  std::vector<DefinedPart> parts_;
  std::vector<PartInStep> constant_, moving_;
  std::vector<std::unique_ptr<PartChain>> chains_;  // chains of moving parts
  std::vector<PartInputs> inputs_;                  // inputs of each part
  std::vector<Resident> residents_;                 // moving parts that are resident
  std::vector<int> drivers_;
};

}  // namespace desmo
