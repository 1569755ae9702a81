#pragma once

#include <span>
#include <string>
#include <vector>

#include "formulations/codegen/record/expression.h"
#include "formulations/model/part_type.h"

namespace desmo::generate {

/// A Jacobian entry ∂Φ_row/∂input of a recorded part type.
struct RecordedEntry {
  int row, input;
  Expr value;
};

/// The equations of a part type as expressions of its local inputs, their rates and its dimensions.
struct RecordedPart {
  std::vector<Expr> q, qd, qdd;  ///< position and rates of each input; rates of fixed ones are zero
  std::vector<Expr> phi;         ///< Φ (rows)
  std::vector<Expr> gamma;       ///< quadratic velocity terms Φ̇_q q̇ (rows)
  /// Entries of Φ_q by inputs that are not fixed:
  /// - constant: entries that depend on dimensions alone
  /// - dependent: all other entries by unknowns
  /// - known: all other entries by known inputs
  std::vector<RecordedEntry> constant, dependent, known;
};

/// A sample point: numeric values of a type's inputs `q` and of its dimensions.
struct SamplePoint {
  std::vector<double> q, constants;
};

/// Records the equations of a part type in the current graph, whose sample points are `samples`.
RecordedPart record(const PartType& type, const std::vector<SamplePoint>& samples);

/// Returns the inputs that a part type solves for, in the order of the columns of its Jacobian.
std::vector<int> unknowns_of(const PartType& type);

/// Returns the position expressions of some inputs.
std::vector<Expr> positions(const RecordedPart& part, const std::vector<int>& inputs);

/// Returns the suffix of an input's C++ variables, appended to q, qd or qdd: "_" and the input's
/// name as an identifier; where an earlier input has the same, then "_" and the input's number. The
/// first underscore avoids keywords and other declared names. Suffixes differ unless an input is
/// named like a numbered one ("a.b", "a_b", "a_b_1"); those of without_names() always do.
std::string variable_name(const PartType& type, int input);

/// The number of states sampled along a motion. A closed form may be singular between two states
/// that are far apart: twelve states missed a branch point in `stephenson_six_bar`.
inline constexpr int sample_count = 45;

/// A part type to generate code for, with sample points from motions of its parts.
struct SampledType {
  std::string name;  ///< namespace of its generated code
  PartType type;
  std::vector<SamplePoint> samples;  ///< all sample points; explicit orders are found at these
  /// Some of the samples, at which the first order of pivots is chosen. Few suffice, because the
  /// kernel monitors its pivots. Where they are too small at other samples, further orders follow.
  std::vector<SamplePoint> pivot_samples;
  /// True if the kernel has only the first order of pivots. Its caller solves by pivoting what that
  /// order refuses.
  bool has_one_order = false;
};

/// Adds the type of a part to `found` unless it is there, and adds sample points to it. A new type
/// has no name yet. Returns the type; the reference is valid until more types are added.
/// - part: lies within one group.
/// - states: states of the model (q, then the fixed values). Each becomes a sample point; at most
///   twenty of them, evenly spaced, become pivot samples (twelve of `sample_count` states).
SampledType& add_part(const Model& model, const PartDefinition& part,
                      std::span<const std::vector<double>> states, std::vector<SampledType>& found);

/// Returns the type with neutral names, so that names from a user's file stay out of generated
/// code. Input 4 becomes u4 (unknown), k4 (known) or f4 (fixed); constraint 2 becomes its kind and
/// number, such as "unit#2".
PartType without_names(PartType type);

}  // namespace desmo::generate
