#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "cases/mechanism.h"
#include "cases/motion.h"
#include "formulations/guess.h"
#include "formulations/part.h"
#include "formulations/partition.h"

namespace desmo {

/// What is asked of an analysis.
struct Request {
  Level level = Level::acceleration;
};

/// One solved instant. The spans are in coordinate order and valid until the next step; those
/// beyond the requested level are empty.
struct Instant {
  int index;
  double time;  ///< s
  std::span<const double> q, qd, qdd;
  long updates = 0;  ///< that it took: see Summary
};

/// Receives solved instants in order of time.
class Sink {
 public:
  virtual ~Sink() = default;
  virtual void accept(const Instant& instant) = 0;
};

/// What became of a step, or of a whole run.
struct Summary {
  Status status = Status::converged;
  long instants = 0;    ///< solved
  long iterations = 0;  ///< Newton iterations, the largest of any part, summed over instants
  /// Unknowns that Newton's method moved: of each part its number times its iterations, summed. The
  /// work of a motion grows with it, beside that of every instant.
  long updates = 0;
  /// Largest ‖Φ‖₂ of the whole mechanism accepted, or that which failed: relative, as the
  /// tolerance.
  double residual = 0;
  GroupId group = -1;   ///< on failure, the group that could not be solved (see find_culprit)
  int constraint = -1;  ///< on failure, the constraint most concerned
  double time = 0;      ///< of the last instant tried, s
  bool ok() const { return status == Status::converged; }
};

/// A sentence for people: the status and, on failure, the group, the constraint and the time.
std::string describe(const Summary& summary, const Mechanism& mechanism);

/// Gives the driven coordinates the position, velocity and acceleration that their motions have at
/// time t (s).
void drive(const Mechanism& mechanism, double t, State& state);

/// One way of solving the kinematics of a mechanism: an ordered list of parts. The mechanism is
/// read only and must outlive the formulation; the formulation owns all that changes.
class Formulation {
 public:
  struct DefinedPart {
    PartDefinition definition;
    std::unique_ptr<Part> solver;
    bool as_named =
        true;  ///< false: automatic, for want of the generated code that its id promises
    Level level = Level::acceleration;  ///< as far as anyone asks for its unknowns
  };

  /// settings: those that the parts were made with.
  Formulation(const Mechanism& mechanism, std::vector<DefinedPart> parts, const Settings& settings);

  /// Assembles the mechanism at time t from its initial estimate, whatever was solved before.
  Summary assemble(double t, Level level = Level::acceleration);
  /// Solves at time t, starting from what the guess makes of the last instant solved; assembles
  /// when there is none. After a failure the positions are those of that instant again, so that a
  /// later step may go on from there; velocities and accelerations are unspecified. What a guess
  /// needs and was not solved in the two instants before, it does without (see best_guess).
  Summary step(double t, Level level = Level::acceleration);
  /// Assembles at the first instant of the grid and steps through the others, handing each to
  /// the sink. Stops at the first failure.
  Summary run(const TimeGrid& grid, const Request& request, Sink& sink);

  /// Leaves out the levels of parts that nobody asks for: a part is solved as far as the highest
  /// level of its unknowns. needed: one for each coordinate; what a part needs must be asked for at
  /// the part's own level or a higher one. Values of levels left out are unspecified.
  void solve_only(std::span<const Level> needed);

  const Mechanism& mechanism() const { return mechanism_; }
  const std::vector<DefinedPart>& parts() const { return parts_; }

  /// The instant solved last, in coordinate order.
  std::span<const double> q() const { return coordinates(state_.q); }
  std::span<const double> qd() const { return coordinates(state_.qd); }
  std::span<const double> qdd() const { return coordinates(state_.qdd); }

 private:
  std::span<const double> coordinates(const std::vector<double>& v) const {
    return {v.data(), static_cast<std::size_t>(mechanism_.coordinates())};
  }
  /// An instant in one of the states, if any.
  struct Solved {
    double time = 0;               // s
    std::optional<Level> level{};  // to which it was solved
  };

  /// What a step does with a part, beside each other in memory.
  struct Stage {
    Part* solver;
    Level level;  // as far as anyone asks for its unknowns
    int part, unknowns;
  };

  void prepare();
  void guess(double t);
  Summary solve(std::span<const Stage> stages, double t, Level level);

  const Mechanism& mechanism_;
  std::vector<DefinedPart> parts_;
  std::vector<Stage> constant_, moving_;  // those that depend on no driver, and the others
  /// Moving unknowns from which a solver starts, by the level to which they are solved.
  std::array<std::vector<CoordinateRun>, 3> started_from_;
  Settings settings_;
  State state_;
  State before_;                  // the instant before that of state_
  std::vector<double> estimate_;  // where a guess is made
  bool assembled_ = false;
  Solved now_, then_;  // what state_ and before_ hold
};

}  // namespace desmo
