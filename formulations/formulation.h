#pragma once

#include <span>
#include <string>

#include "formulations/base/observer.h"
#include "formulations/base/settings.h"
#include "formulations/base/summary.h"
#include "formulations/model/model.h"

namespace desmo {

/// A way of solving the kinematics of a mechanism: an ordered list of parts, and the order in which
/// they solve the instants of a motion. make_formulation() makes one:
///
///   const Model model = make_model(scene);
///   const auto formulation = make_formulation(find_variant("group_symbolic_explicit"), model);
///   if (!formulation->assemble(0).ok()) return;
///   for (int i = 1; i <= 100; ++i)
///     if (formulation->step(0.01 * i).ok())
///       use(formulation->value("C.x"), formulation->value("C.x", Level::velocity));
///
/// run_checked() and LiveRun can also prove how accurate the answers are.
///
/// Rule of threads, in all of desmo:
/// - Threads may share what nobody changes meanwhile: a Model, Settings, generated code and all
///   tables, such as variants(). A Model and generated code must outlive the formulations that use
///   them.
/// - One thread at a time uses a Formulation, a LiveRun or an Observer: each thread makes its own.
/// - A formulation with Settings::threads above 1 may call its observer from several threads, one
///   call at a time. Observers that Observer::of_thread() returns are called without a lock, each
///   by one thread.
/// - The whole process shares the number of threads that OpenBLAS uses inside `lapack`. Set the
///   environment variable OPENBLAS_NUM_THREADS to 1 where several threads solve.
class Formulation {
 public:
  virtual ~Formulation() = default;
  Formulation(const Formulation&) = delete;
  Formulation& operator=(const Formulation&) = delete;

  /// Assembles the mechanism at time t [s] from the model's estimate; forgets what was solved
  /// before. level: the highest that is solved. After a failure all coordinates are unspecified,
  /// and the next step assembles. Neither this nor step() throws, unless memory runs out. A step
  /// after this one, or after another step, takes no heap memory if it succeeds without sub-steps;
  /// a library of linear algebra may take some.
  virtual Summary assemble(double t, Level level = Level::acceleration) = 0;

  /// Solves the instant at time t [s], from the prediction or, where that fails, in sub-steps.
  /// Assembles where nothing was solved before, or the last assembly failed. After any other
  /// failure positions are those before the call, and the next step goes on from there; rates are
  /// unspecified. Where earlier instants were solved to lower levels than Settings::guess needs, a
  /// simpler guess replaces it. t may be any number: an earlier one goes back, and the one of the
  /// last instant solves that again. NaN or an infinite t fails, usually as Status::not_finite.
  virtual Summary step(double t, Level level = Level::acceleration) = 0;

  /// Runs through the motion that the model's drivers have: assembles at the first instant of the
  /// grid, solves the others as the settings say, and hands each to the observer. Stops at the
  /// first failure, after it handed on all that it solved, or where the observer says so. A run
  /// that the observer stops leaves the formulation at the last instant handed on. With segments,
  /// threads or a stride it is an unspecified one. Throws std::invalid_argument for a request that
  /// names a coordinate twice or one that does not exist.
  virtual Summary run(const TimeGrid& grid, const Request& request, Observer& observer) = 0;

  /// Limits later steps and runs: each part is solved only to the highest level that is needed of
  /// its unknowns. Values above these levels are unspecified. With Settings::stride above 1 all
  /// levels are solved, since interpolation needs them. Call it between steps or runs, never in a
  /// run. Where it raises levels, assemble next: a step would predict from rates that were not
  /// solved.
  /// - needed: the level of each coordinate, as Plan::levels has them. A coordinate that a part
  ///   reads must have the part's level or a higher one.
  /// Throws std::invalid_argument where `needed` has not one level for each coordinate.
  virtual void solve_only(std::span<const Level> needed) = 0;

  const Model& model() const { return model_; }

  /// Returns the settings that the formulation was made with.
  const Settings& settings() const { return settings_; }

  /// Returns the limit of ‖Φ‖₂ of the whole mechanism, relative like Settings::tolerance, that
  /// every solved instant meets. It is the settings' tolerance or, if larger, what rounding leaves:
  /// with many bodies in a row, or far from the origin. With Settings::fixed_iterations instants
  /// need not meet it.
  double tolerance() const { return tolerance_; }

  /// Return positions, velocities and accelerations of the instant solved last, in coordinate order
  /// (Model::coordinates() values). They are unspecified before the first instant and during a run,
  /// where an observer reads its Instant.
  std::span<const double> q() const;
  std::span<const double> qd() const;
  std::span<const double> qdd() const;

  /// Returns a value of the instant solved last, or its rate, by its name, such as "C.x" or
  /// "theta". Throws std::invalid_argument when there is no such name. In a loop, read q()[i]
  /// instead, with i = Model::coordinate(name) looked up before.
  double value(const std::string& name, Level level = Level::position) const;

 private:
  // TimeStepping is the only derived class. The library reaches it through motion/internals.h,
  // which is not installed.
  friend class TimeStepping;
  Formulation(const Model& model, const Settings& settings, double tolerance)
      : model_(model), settings_(settings), tolerance_(tolerance) {}

  const Model& model_;
  const Settings settings_;
  double tolerance_;
};

/// Returns status and residual as a text. On success it adds the numbers of instants and
/// iterations, on failure the time and, if known, group and constraint.
std::string describe(const Summary& summary, const Model& model);

}  // namespace desmo
