#pragma once

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "cases/mechanism/motion.h"
#include "formulations/base/part.h"
#include "formulations/base/room.h"
#include "formulations/model/model.h"
#include "formulations/prediction/motions_ahead.h"
#include "formulations/prediction/predictor.h"
#include "formulations/stepping/keepers.h"
#include "formulations/structure/partition.h"

namespace desmo {

/// What is asked of an analysis.
struct Request {
  Level level = Level::acceleration;
  /// Those that the observer reads, none standing for all; the others may be unspecified.
  std::span<const int> coordinates{};
};

/// One instant of a motion. The spans are in coordinate order and valid until the next step; those
/// beyond the requested level are empty.
struct Instant {
  int index;
  double time;  ///< s
  std::span<const double> q, qd, qdd;
  long updates = 0;           ///< that it took: see Summary
  double residual = 0;        ///< ‖Φ‖₂ where it was accepted, as in Summary
  bool interpolated = false;  ///< between those solved (see Settings::stride)
  Room room{};  ///< the observer's own, if the values are there; the spans are then empty

  bool in_room() const { return room.q; }
};

/// Receives the instants of a motion in order of time.
class Observer {
 public:
  virtual ~Observer() = default;
  virtual void observe(const Instant& instant) = 0;
  /// What rooms are for, at an observer that has one for every instant. A solver may put the values
  /// there, which saves a copy, or hand them to observe() all the same.
  virtual std::optional<RoomShape> rooms() const { return {}; }
  /// At such an observer, a room for each of these instants, which are to come. It is the solver's
  /// until it comes back with its instant. Many may be under way, and come back in any order; those
  /// of a run that is given up do not.
  virtual void take_rooms(std::span<const int> indices, std::span<Room> rooms) {
    static_cast<void>(indices), static_cast<void>(rooms);
  }
  /// Whether they may come in any order, and again, the later then being the one that holds. Who
  /// solves several at once keeps all of them for an observer that needs their order.
  virtual bool takes_any_order() const { return false; }
};

/// What became of a step, or of a whole run.
struct Summary {
  Status status = Status::converged;
  long instants = 0;    ///< solved, or interpolated between those solved
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
std::string describe(const Summary& summary, const Model& model);

/// Gives the driven coordinates the position, velocity and acceleration that their motions have at
/// time t (s).
void drive(const Model& model, double t, State& state);

/// Runs through a motion that is known in advance otherwise than step by step.
class WholeMotion {
 public:
  virtual ~WholeMotion() = default;
  /// Hands every instant of the grid to an observer that takes any order. state: the first,
  /// assembled; overwritten by the last. Nothing when it has to be done step by step after all; the
  /// state and what the observer was given are then of no meaning.
  virtual std::optional<Summary> run(const TimeGrid& grid, const Request& request, State& state,
                                     Observer& observer) = 0;
  /// As Formulation::solve_only(): what may be left out.
  virtual void solve_only(std::span<const Level>) {}
};

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
    /// On ‖Φ‖₂ of its equations: its share, or what rounding leaves if that is more.
    double tolerance = 0;
  };

  /// settings: those that the parts were made with. whole_motion: how to run, if not by steps.
  Formulation(const Model& model, std::vector<DefinedPart> parts, const Settings& settings,
              std::unique_ptr<WholeMotion> whole_motion = nullptr);

  /// Assembles the mechanism at time t from its initial estimate, whatever was solved before.
  Summary assemble(double t, Level level = Level::acceleration);
  /// Solves at time t, starting from what the guess makes of the last instant solved or, where it
  /// fails, by way of times between; assembles when there is none. After a failure positions are as
  /// they were, for a later step to go on from there; rates are unspecified. What a guess needs
  /// and was not solved in the instants before, it does without (see Predictor).
  Summary step(double t, Level level = Level::acceleration);
  /// Assembles at the first instant of the grid and steps through the others, or takes several at
  /// once, or solves some and interpolates the others, where settings say so; hands each to the
  /// observer. Stops at the first failure: up to the last instant solved before it, all were handed
  /// on.
  Summary run(const TimeGrid& grid, const Request& request, Observer& observer);

  /// Goes to where a motion is at time t without its instants before: from q (the state as far as
  /// positions, coordinates and fixed entities), solved at another instant, along a way on which
  /// the drivers go straight. A step goes on from there. False where that way cannot be gone.
  bool enter(std::span<const double> q, double t);
  /// As run(), of a motion whose first instant is where enter() has gone. Nothing when an instant
  /// could not be solved, or not at once; what the observer was given is then of no meaning.
  std::optional<Summary> run_on(const TimeGrid& grid, const Request& request, Observer& observer);

  /// Leaves out the levels of parts that nobody asks for: a part is solved as far as the highest
  /// level of its unknowns. needed: one for each coordinate; what a part needs must be asked for at
  /// the part's own level or a higher one. Values of levels left out are unspecified. Where
  /// instants are interpolated nothing is left out, for that takes all levels.
  void solve_only(std::span<const Level> needed);

  /// How often a motion that was to be solved at once was solved step by step after all.
  long run_by_steps() const { return run_by_steps_; }

  /// Of all parts: how often pivots that were to be kept had gone bad (Part::refactorisations).
  long refactorisations() const;

  const Model& model() const { return model_; }
  const std::vector<DefinedPart>& parts() const { return parts_; }

  /// On ‖Φ‖₂ of the whole mechanism: as asked for, or what rounding leaves if that is more, as in
  /// long chains and far from the origin (Magnitudes::rounding).
  double tolerance() const { return tolerance_; }

  /// The instant solved last, in coordinate order. While a run goes on that is asked for some
  /// coordinates, the others are unspecified.
  std::span<const double> q() const { return coordinates(state_.q); }
  std::span<const double> qd() const { return coordinates(state_.qd); }
  std::span<const double> qdd() const { return coordinates(state_.qdd); }

 private:
  std::span<const double> coordinates(const std::vector<double>& v) const {
    return {v.data(), static_cast<std::size_t>(model_.coordinates())};
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
    PartRun* run = nullptr;  // that it is a member of, if any …
    int member = 0;          // … and which
  };

  /// What others than parts read of each instant.
  struct Wanted {
    std::vector<int> coordinates{};  // none standing for all …
    bool in_rooms = false;           // … in rooms that are for them, or in the state
  };

  /// A driven coordinate, and where it stands among what motions_ samples.
  struct Driven {
    int coordinate, in_row;
  };

  void prepare();
  void make_runs();
  void sample_drivers();
  void forget();
  void end_assembly();
  void want(std::span<const int> coordinates, bool in_rooms = false);
  void want_as(const Request& request, Observer& observer);
  void write_kept(const Summary& total);
  Summary assemble_alone(double t, Level level);
  Summary advance(double t, Level level);
  bool solve_positions(State& state, std::span<const double> last);
  Summary solve_all(const TimeGrid& grid, const Request& request, Observer& observer);
  Summary take_steps(const TimeGrid& grid, const Request& request, Observer& observer);
  bool solve_next(int i, double t, const Request& request, Observer& observer, Summary& total);
  std::optional<Summary> run_at_once(const TimeGrid& grid, const Request& request,
                                     Observer& observer);
  void begin_step(double t);
  void drive(double t);
  void write(std::span<const Driven> drivers);
  Summary solve(std::span<const Stage> stages, double t, Level level);

  const Model& model_;
  MotionsAhead motions_;                 // of the drivers, those that keepers want first
  MotionRow sampled_{};                  // what they do at the instant driven to last
  std::vector<Driven> drivers_;          // of the mechanism …
  std::vector<Driven> driven_in_state_;  // … and those that are read in the state
  std::vector<DefinedPart> parts_;
  std::vector<Stage> constant_, moving_;        // those that depend on no driver, and the others
  std::vector<std::unique_ptr<PartRun>> runs_;  // of moving ones
  Keepers keepers_;                             // of moving parts
  Wanted wanted_;
  /// Of moving unknowns from which a solver starts, by the level to which they are solved.
  std::array<Predictor, 3> predictors_;
  std::vector<int> near_;  // coordinates that stay near the last ones
  Settings settings_;
  double tolerance_;
  State state_;
  State before_;  // the instant before that of state_
  bool assembled_ = false;
  Solved now_, then_;  // what state_ and before_ hold
  std::unique_ptr<WholeMotion> whole_motion_;
  long run_by_steps_ = 0;
};

}  // namespace desmo
