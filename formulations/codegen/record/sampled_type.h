#pragma once

#include <span>
#include <string>
#include <vector>

#include "formulations/codegen/record/recording.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// The number of states of a motion that are sampled. A closed form may be singular between two
/// that are far apart: with twelve, a square root of `stephenson_six_bar` passed its branch point
/// unseen.
inline constexpr int sample_count = 45;

/// A type of part to generate code for, and places along motions where its parts were.
struct SampledType {
  std::string name;  ///< of its namespace in the code
  PartType type;
  std::vector<SamplePoint> samples;        ///< for explicit orders
  std::vector<SamplePoint> pivot_samples;  ///< some of them, for eliminations: pivots take longer
                                           ///< to choose, and are watched while they run
};

/// Adds the type of a part of one group, without a name, to those found, unless it is one of them.
/// Adds to its samples one for each state (q, then the fixed values) of the mechanism, and some
/// twelve of these to those for pivots. Returns the type; valid until more are added.
SampledType& add_part(const Model& model, const PartDefinition& part,
                      std::span<const std::vector<double>> states, std::vector<SampledType>& found);

/// The type with names made of numbers, the same for all types of one fingerprint: u4, an unknown,
/// k0, known, or f7, fixed, is the input at that position, and "unit#2" the constraint at that one.
/// The names that a file gives its entities stay out of code that is generated for it.
PartType without_names(PartType type);

}  // namespace desmo::generate
