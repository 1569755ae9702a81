#pragma once

#include <string>
#include <vector>

#include "formulations/model/partition.h"

namespace desmo {

/// The role of a scalar input in a part's equations.
enum class Role {
  unknown,  ///< the part solves for it
  known,    ///< an earlier part solves for it, or a driver prescribes it
  fixed,    ///< it never moves
};

/// The type of a part: its equations in canonical form. Variables are *local inputs*, numbered by
/// first appearance. Parts with equal fingerprints have the same equations, and the same dimensions
/// are zero. They differ only in the state indices of their inputs and in their other dimensions.
/// One generated kernel serves all parts of a type.
struct PartType {
  struct Constraint {
    int kind;                   ///< position in ConstraintKinds
    std::vector<int> operands;  ///< first local input of each operand
    int first_constant;         ///< position of its first dimension in `constants`
    std::vector<int> rows;      ///< its scalar equations that belong to the part
  };
  struct Input {
    std::string name;  ///< entity and component, without the prefix of its group: "x2.y"
    Role role;
    int state;  ///< index in the state of the model that the part belongs to
  };

  std::string fingerprint;  ///< equal for parts of one type
  std::vector<Constraint> constraints;
  std::vector<std::string> row_names;  ///< name of each scalar equation's constraint
  std::vector<Input> inputs;
  std::vector<double> constants;  ///< dimensions, constraint by constraint

  int rows() const { return static_cast<int>(row_names.size()); }
};

/// Returns the canonical form of a part, which may span several groups.
PartType describe_type(const Model& model, const PartDefinition& part);

/// Reorders parts so that parts of one type follow each other, which keeps their code in the cache.
/// Constant parts stay first. The others are ordered by depth (length of the longest sequence of
/// parts that must be solved before), then by type. Returns the end position of each range of parts
/// that share type and depth; moving parts of one range do not depend on each other.
std::vector<int> gather_types(const Model& model, std::vector<PartDefinition>& parts);

}  // namespace desmo
