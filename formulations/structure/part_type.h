#pragma once

#include <string>
#include <vector>

#include "formulations/structure/partition.h"

namespace desmo {

/// What a scalar input of a part's equations is to the part.
enum class Role {
  unknown,  ///< solved for by the part
  known,    ///< found by an earlier part, or driven
  fixed,    ///< never moves
};

/// A group, or a block of one, in canonical form: its equations over local inputs, numbered by
/// first appearance. Parts with equal fingerprints have the same equations, with the same of their
/// dimensions zero, and differ only in where their inputs stand in the state and in their other
/// dimensions, so that one generated kernel serves them all.
struct PartType {
  struct Constraint {
    int kind;                   ///< position in ConstraintKinds
    std::vector<int> operands;  ///< first local input of each
    int first_constant;
    std::vector<int> rows;  ///< of its scalar equations, those that belong to the part
  };
  struct Input {
    std::string name;  ///< entity and component, without the prefix of its group: "x2.y"
    Role role;
    int state;  ///< in the state of the mechanism it was taken from
  };

  std::string fingerprint;
  std::vector<Constraint> constraints;
  std::vector<std::string> row_names;  ///< constraint of each scalar equation
  std::vector<Input> inputs;
  std::vector<double> constants;

  int rows() const { return static_cast<int>(row_names.size()); }
};

/// The canonical form of a part, of one group or more.
PartType describe_type(const Model& model, const PartDefinition& part);

}  // namespace desmo
