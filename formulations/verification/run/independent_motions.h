#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "formulations/verification/run/checked_motion.h"

namespace desmo {

struct Submodel;

/// The motion of a checked run, by independent mechanisms. Each is followed as if it stood alone in
/// its file: a change point or a lost branch concerns one of them alone. While all are proven they
/// are followed together, which costs less.
///
/// Functions are those of CheckedMotion. A row has the flags of all mechanisms, the worst first.
class IndependentMotions {
 public:
  /// tolerance: Formulation::tolerance(), which the instants of is_on_step() meet.
  IndependentMotions(const Model& model, std::span<const Level> levels, double tolerance);
  ~IndependentMotions();

  void begin(double time);
  /// Tries a row after one that could not be solved. Follows each mechanism to it or, where that is
  /// not possible, begins it again there. Returns whether all get there; false if there is only one
  /// mechanism. Those that get there go on from this row in any case, with their branches and
  /// turns.
  /// - wanted: the row, as for solve()
  bool try_again(const Instant& wanted);
  /// Makes the row of the last try_again() the next one: a single mechanism begins again there.
  void begin_again(double time);
  const CheckedInstant& check(const Instant& solved) { return *take(solved, true); }
  const CheckedInstant* solve(const Instant& wanted) { return take(wanted, false); }
  bool is_on_step(const Instant& instant) const;
  void return_to_last();
  /// Returns nothing if one of the mechanisms has not been followed.
  std::vector<double> followed_to() const;
  FoundStart::Stage start() const;

 private:
  struct SubmodelMotion;
  struct State {
    bool together = true;    // the motion is followed as a whole
    bool has_begun = false;  // there is a row
  };

  const CheckedInstant* take(const Instant& at, bool is_solved);
  bool take_each(const Instant& at, bool is_solved);
  bool separate();
  void join();
  void add(const Submodel& of, const CheckedInstant& row, const std::optional<RowFlag>& flag);

  const Model& m_;
  const std::span<const Level> levels_;
  std::vector<double> tolerances_;  // nominal magnitude × tolerance of each coordinate
  CheckedMotion together_;
  // Null: not needed so far. Empty: there is one mechanism.
  std::optional<std::vector<std::unique_ptr<SubmodelMotion>>> each_;
  State state_, last_;  // last_: before the last check or try
  double begin_ = 0;    // time at which the motion begins [s]
  PerLevel<std::vector<double>> values_, radius_;
  std::vector<RowFlag> flags_;  // of the mechanisms, the worst first
  CheckedInstant result_;
};

}  // namespace desmo
