#pragma once

#include <string>
#include <vector>

#include "cases/mechanism.h"

namespace desmo {

/// What a scalar input of a group's equations is to the group.
enum class Role {
  unknown,  ///< solved for by the group
  known,    ///< found by an earlier group, or driven
  fixed,    ///< never moves
};

/// A group in canonical form: its equations over local inputs, numbered by first appearance.
/// Groups with equal fingerprints have the same equations and differ only in where their inputs
/// stand in the state and in their dimensions, so that one generated kernel serves them all.
struct GroupType {
  struct Equation {
    int kind;                   ///< position in ConstraintKinds
    std::vector<int> operands;  ///< first local input of each
    int first_constant;
  };
  struct Input {
    std::string name;  ///< entity and component, without the group's prefix: "x2.y"
    Role role;
    int state;  ///< in the state of the mechanism it was taken from
  };

  std::string fingerprint;
  std::vector<Equation> equations;
  std::vector<std::string> row_names;  ///< constraint of each scalar equation
  std::vector<Input> inputs;
  std::vector<double> constants;
  int rows = 0;
};

/// The canonical form of one group of a mechanism.
GroupType describe_group(const Mechanism& mechanism, GroupId group);

}  // namespace desmo
