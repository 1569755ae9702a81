#pragma once

#include <vector>

#include "formulations/codegen/record/expression.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// A Jacobian entry ∂Φ_row/∂input of a recorded part type.
struct RecordedEntry {
  int row, input;
  Expr value;
};

/// The equations of a part type as expressions of its local inputs, their rates and its dimensions.
struct RecordedPart {
  std::vector<Expr> q, qd, qdd;  ///< position and rates of each input; rates of fixed ones are zero
  std::vector<Expr> phi;         ///< Φ
  std::vector<Expr> gamma;       ///< Φ̇_q q̇
  /// Entries of Φ_q without fixed inputs. constant: depend on dimensions alone; dependent: others
  /// by unknowns; known: others by known inputs.
  std::vector<RecordedEntry> constant, dependent, known;
};

/// A sample point: numeric values of a type's inputs `q` and of its dimensions.
struct SamplePoint {
  std::vector<double> q, constants;
};

/// Records the equations of a part type in the current graph, whose sample points are `samples`.
RecordedPart record(const PartType& type, const std::vector<SamplePoint>& samples);

/// Returns the position expressions of some inputs.
std::vector<Expr> positions(const RecordedPart& part, const std::vector<int>& inputs);

/// Returns the suffix of an input's C++ variables, appended to q, qd or qdd: "_" and the input's
/// name, unique within the type. The underscore avoids keywords and other declared names.
std::string variable_name(const PartType& type, int input);

}  // namespace desmo::generate
