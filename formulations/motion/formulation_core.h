#pragma once

#include <memory>
#include <span>
#include <vector>

#include "formulations/base/live_row.h"
#include "formulations/base/part.h"
#include "formulations/formulation.h"
#include "formulations/model/partition.h"

namespace desmo {

struct Profile;  // parts/profile.h
struct Variant;  // variants.h

/// The steps of a formulation whose driver values are handed in. LiveRun is made of them; it also
/// checks the rows and proves the results.
class LiveSteps {
 public:
  virtual ~LiveSteps() = default;

  /// Solves an instant like Formulation::step(), with driver values from a row instead of the
  /// motions. Takes at most max_sub_steps sub-steps, in which drivers move linearly from their last
  /// positions to the row. Takes nothing from the heap unless it assembles; so a failure names the
  /// group at most, and no constraint. The row is not checked.
  virtual Summary step_to_row(const LiveRow& row, Level level, int max_sub_steps) = 0;

  /// Returns to positions q that were solved before, at time t [s]; the next row starts there.
  /// Rates become unknown. q: Model::coordinates() values or more; empty: the next row is
  /// assembled.
  virtual void return_to(std::span<const double> q, double t) = 0;
};

/// The interface of a formulation to the rest of the library; core_of() returns it. Users of
/// formulations need none of it.
class FormulationCore : public Formulation {
 public:
  /// Returns the instant solved last, the fixed entities included.
  virtual const State& state() const = 0;
  /// Returns the parts in the order of solution.
  virtual const std::vector<DefinedPart>& parts() const = 0;

  /// Goes to time t [s] of the motion without solving the instants before, by continuation: drivers
  /// move linearly from the positions q to where they are at t. q: Model::coordinates() values or
  /// more, solved at another instant. A step goes on from there, in sub-steps where it has to.
  /// Returns false where the position cannot be reached; the next step then assembles.
  virtual bool start_at(std::span<const double> q, double t) = 0;

  /// Returns how often a motion that was to be solved in segments was solved step by step instead.
  virtual long runs_without_segments() const { return 0; }

  /// Returns whether the settings need a motion known in advance. More than the parts then do the
  /// work.
  bool needs_known_motion() const {
    return settings().segments > 1 || settings().threads > 1 || settings().stride > 1;
  }
  /// Returns the steps for drivers that are handed in; null where needs_known_motion().
  virtual LiveSteps* live() { return nullptr; }

 protected:
  FormulationCore(const Model& model, const Settings& settings, double tolerance)
      : Formulation(model, settings, tolerance) {}
};

/// Return the interface of a formulation to the library. Only FormulationCore derives from
/// Formulation, so every formulation has it.
inline FormulationCore& core_of(Formulation& formulation) {
  return static_cast<FormulationCore&>(formulation);
}
inline const FormulationCore& core_of(const Formulation& formulation) {
  return static_cast<const FormulationCore&>(formulation);
}

/// Returns the parts of a formulation in the order of solution.
inline const std::vector<DefinedPart>& parts_of(const Formulation& formulation) {
  return core_of(formulation).parts();
}

/// Makes a formulation like make_formulation(). profile: receives the time of each phase on the
/// caller's thread; outlives the formulation.
std::unique_ptr<Formulation> make_profiled_formulation(const Variant& variant, const Model& model,
                                                       const Settings& settings, Profile& profile);

/// Returns the sum of Part::counts() over all parts.
PartCounts part_counts(const Formulation& formulation);

}  // namespace desmo
