#pragma once

#include <span>
#include <string>
#include <vector>

#include "formulations/codegen/record/recording.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// The number of states sampled along a motion. A closed form may be singular between two states
/// that are far apart: twelve states missed a branch point in `stephenson_six_bar`.
inline constexpr int sample_count = 45;

/// A part type to generate code for, with sample points from motions of its parts.
struct SampledType {
  std::string name;  ///< namespace of its generated code
  PartType type;
  std::vector<SamplePoint> samples;        ///< sample points for explicit orders
  std::vector<SamplePoint> pivot_samples;  ///< a subset for eliminations: choosing pivots takes
                                           ///< longer, and pivots are monitored at run time
};

/// Adds the type of a part to `found` unless it is there, and adds sample points to it. A new type
/// has no name yet. Returns the type; the reference is valid until more types are added.
/// - part: lies within one group.
/// - states: states of the model (q, then the fixed values); each becomes a sample point, and about
///   twelve of them become pivot samples.
SampledType& add_part(const Model& model, const PartDefinition& part,
                      std::span<const std::vector<double>> states, std::vector<SampledType>& found);

/// Returns the type with neutral names, so that names from a user's file stay out of generated
/// code. Input 4 becomes u4 (unknown), k4 (known) or f4 (fixed); constraint 2 becomes its kind and
/// number, such as "unit#2".
PartType without_names(PartType type);

}  // namespace desmo::generate
