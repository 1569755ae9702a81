#pragma once

#include <vector>

#include "formulations/codegen/record/expression.h"
#include "formulations/structure/part_type.h"

namespace desmo::generate {

/// A partial derivative ∂Φ_row/∂input of a recorded group.
struct RecordedEntry {
  int row, input;
  Expr value;
};

/// The equations of a group type as expressions over its local inputs (named in[i]), their rates
/// and its dimensions.
struct RecordedPart {
  std::vector<Expr> q, qd, qdd;  ///< of each input; rates of fixed ones are zero
  std::vector<Expr> phi;         ///< Φ
  std::vector<Expr> gamma;       ///< Φ̇_q q̇
  std::vector<RecordedEntry> constant, dependent, known;  ///< Φ_q; fixed inputs left out
};

/// One place of the type to sample: positions of its inputs, and its dimensions.
struct SamplePoint {
  std::vector<double> q, constants;
};

/// Runs the constraint code of a group type on the recording scalar, in the current graph.
RecordedPart record(const PartType& type, const std::vector<SamplePoint>& samples);

/// The positions of some inputs.
std::vector<Expr> positions(const RecordedPart& part, const std::vector<int>& inputs);

/// What follows q, qd or qdd in the C++ variable of an input: "_" and its name, unique within the
/// type. The prefix keeps it apart from keywords and from whatever else the code declares.
std::string variable_name(const PartType& type, int input);

}  // namespace desmo::generate
