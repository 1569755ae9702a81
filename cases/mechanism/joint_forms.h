#pragma once

#include <span>
#include <string_view>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Form of a joint type in the plane or in space: its name in files, the points and vectors that it
/// joins, and the freedoms that it removes.
/// - A common entity (point or vector) is carried by both bodies, an own one by one body.
/// - In a joint's lists common entities come first, then the first body's own one, then the
///   second's.
/// - Of two own points, the second slides as seen from the first body: along the joint's first
///   vector, or, with in_plane, at right angles to that vector.
struct JointForm {
  Mechanism::JointType type;
  int dimension;
  std::string_view name;
  int freedoms_removed;
  int common_points = 0, own_points = 0, common_vectors = 0, own_vectors = 0;
  bool in_plane = false;   ///< own points slide in a plane, not along a line
  std::string_view takes;  ///< description of its points and vectors, for messages

  int points() const { return common_points + own_points; }
  int vectors() const { return common_vectors + own_vectors; }
};

/// Returns whether a point of a joint of this type slides along a line.
bool slides(Mechanism::JointType type);

/// Returns whether a joint of this type turns about one axis.
bool turns(Mechanism::JointType type);

/// Returns the forms of all types, one for each dimension in which a type exists.
std::span<const JointForm> joint_forms();

/// Returns the form of a type in a dimension; null when there is none.
const JointForm* find_joint_form(Mechanism::JointType type, int dimension);

}  // namespace desmo
