#pragma once

#include <span>
#include <string_view>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// What a type of joint joins, in the plane or in space. A joint's lists hold either entities that
/// both bodies carry, or own ones: the first body's, then the second's.
struct JointForm {
  Mechanism::JointType type;
  int dimension;
  std::string_view name;
  int common_points, own_points, common_vectors, own_vectors;
  std::string_view takes;  ///< for messages

  int points() const { return common_points + own_points; }
  int vectors() const { return common_vectors + own_vectors; }
};

/// Every type of joint in each dimension in which it exists.
std::span<const JointForm> joint_forms();

/// Null when there is no such joint in this dimension.
const JointForm* find_joint_form(Mechanism::JointType type, int dimension);

}  // namespace desmo
