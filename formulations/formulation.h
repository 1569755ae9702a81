#pragma once

#include <optional>
#include <span>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/base/settings.h"
#include "formulations/base/summary.h"
#include "formulations/model/model.h"
#include "formulations/structure/defined_part.h"

namespace desmo {

struct DefinedPart;
struct State;

/// A way of solving the kinematics of a mechanism: an ordered list of parts, and how they go
/// through a motion. make_formulation() (variants.h) makes one:
///
///   const Model model = make_model(scene);
///   const auto formulation = make_formulation(find_variant("group_symbolic_explicit"), model);
///   formulation->assemble(0);
///   for (int i = 1; i <= 100; ++i)
///     if (formulation->step(0.01 * i).ok()) use(formulation->q(), formulation->qd());
///
/// Threads may share whatever is const, in all of desmo. A Model, the tables of variants, cases
/// and the library, Settings and generated code are read only and may be used by formulations on
/// any number of threads; they outlive these. A Formulation, a LiveRun and an Observer own what
/// changes, and are used by one thread at a time: a formulation for each thread. A formulation with
/// `threads` calls its observer from several, one call at a time, or the observers that
/// Observer::of_thread() gives, each from its own thread.
class Formulation {
 public:
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  /// Assembles the mechanism at time t [s] from the model's estimate, whatever was solved before.
  virtual Summary assemble(double t, Level level = Level::acceleration) = 0;

  /// Solves at time t [s], starting from the prediction or, where that fails, by sub-steps;
  /// assembles where nothing was solved before. After a failure positions are as they were, for a
  /// later step to go on from there; rates are unspecified. The predictor does without what it
  /// needs and was not solved in the instants before.
  virtual Summary step(double t, Level level = Level::acceleration) = 0;

  /// Returns whether drivers may be handed in step by step: not where the settings ask for a motion
  /// known in advance (segments, threads, stride).
  virtual bool is_live() const { return false; }
  /// Like step(), with values handed in for the drivers instead of their motions; assembles at the
  /// row where nothing was solved before. Sub-steps go straight from the last positions to the row,
  /// max_sub_steps tries in all. Takes nothing from the heap, which step() may on failure: of a
  /// failure it names the group alone, where there is one. See LiveRun, which looks at rows and
  /// results.
  virtual Summary step(const LiveRow&, Level, int max_sub_steps) {
    static_cast<void>(max_sub_steps);
    return {.status = Status::not_converged};
  }
  /// Goes back to positions solved before, at time t [s], from which live steps go on; rates are
  /// unknown. q: coordinates() values or more; empty: the next step assembles.
  virtual void return_to(std::span<const double>, double t) { static_cast<void>(t); }

  /// Runs through a motion: assembles at the first instant of the grid, solves the others as the
  /// settings say, and hands each to the observer. Stops at the first failure, all instants before
  /// it handed on, or where the observer stops it; segments solved at once then leave the
  /// formulation at the first instant. Throws std::invalid_argument for a request that names a
  /// coordinate twice or one that does not exist.
  virtual Summary run(const TimeGrid& grid, const Request& request, Observer& observer) = 0;

  /// Goes to the position of a motion at time t [s] without its instants before, by continuation:
  /// from q (state_size() values of positions, solved at another instant) the drivers go straight.
  /// A step goes on from there. Returns false where that cannot be done.
  virtual bool start_at(std::span<const double> q, double t) = 0;

  /// Like run(), but starts at the position that start_at() reached. Returns nothing when an
  /// instant could not be solved, or not at once; what the observer was given is then void.
  virtual std::optional<Summary> run_on(const TimeGrid& grid, const Request& request,
                                        Observer& observer) = 0;

  /// Leaves out the levels of parts that nobody asks for: a part is solved to the highest level of
  /// its unknowns. needed: one for each coordinate; what a part needs must be asked for at the
  /// part's own level or a higher one. Values of levels left out are unspecified. Where instants
  /// are interpolated nothing is left out, for that takes all levels.
  virtual void solve_only(std::span<const Level> needed) = 0;

  /// Returns how often a motion that was to be solved at once was solved step by step after all.
  virtual long run_by_steps() const { return 0; }

  virtual const std::vector<DefinedPart>& parts() const = 0;

  /// The instant solved last: q, q̇, q̈ of the coordinates, then of the fixed entities. While a run
  /// goes on that is asked for some coordinates, the others are unspecified.
  virtual const State& state() const = 0;

  const Model& model() const { return model_; }

  /// Returns the settings that the formulation was made with.
  const Settings& settings() const { return settings_; }

  /// Returns the bound on ‖Φ‖₂ of the whole mechanism that instants meet: the one of the settings,
  /// or what rounding leaves if that is more, as in long chains and far from the origin
  /// (Magnitudes::rounding).
  double tolerance() const { return tolerance_; }

  /// Returns how often, in all parts, pivots that were to be kept had gone bad
  /// (Part::refactorisations).
  long refactorisations() const;

  /// The instant solved last, in coordinate order (coordinates() values).
  std::span<const double> q() const;
  std::span<const double> qd() const;
  std::span<const double> qdd() const;

 protected:
  Formulation(const Model& model, const Settings& settings, double tolerance)
      : model_(model), settings_(settings), tolerance_(tolerance) {}

 private:
  const Model& model_;
  const Settings settings_;
  double tolerance_;
};

}  // namespace desmo
