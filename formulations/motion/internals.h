#pragma once

#include <memory>
#include <vector>

#include "formulations/base/part.h"
#include "formulations/formulation.h"
#include "formulations/motion/time_stepping.h"

namespace desmo {

struct Profile;  // defined in parts/profile.h
struct Variant;  // defined in variants.h

/// Return the interface of a formulation for the rest of the library; its users need none of it.
/// Only TimeStepping derives from Formulation, so every formulation has it.
inline TimeStepping& stepping_of(Formulation& formulation) {
  return static_cast<TimeStepping&>(formulation);
}
inline const TimeStepping& stepping_of(const Formulation& formulation) {
  return static_cast<const TimeStepping&>(formulation);
}

/// Returns the parts of a formulation in the order of solution.
inline const std::vector<DefinedPart>& parts_of(const Formulation& formulation) {
  return stepping_of(formulation).parts();
}

/// Makes a formulation like make_formulation(). profile: receives the time of each phase on the
/// caller's thread; outlives the formulation.
std::unique_ptr<Formulation> make_profiled_formulation(const Variant& variant, const Model& model,
                                                       const Settings& settings, Profile& profile);

/// Returns the sum of Part::counts() over all parts.
PartCounts part_counts(const Formulation& formulation);

}  // namespace desmo
