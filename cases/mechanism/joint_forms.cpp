#include "cases/mechanism/joint_forms.h"

#include <algorithm>
#include <array>

namespace desmo {

std::span<const JointForm> joint_forms() {
  using enum Mechanism::JointType;
  static constexpr std::array table{
      JointForm{revolute, 2, "revolute", 1, 0, 0, 0, 2, "one point, of both bodies"},
      JointForm{prismatic, 2, "prismatic", 0, 2, 1, 0, 2,
                "one vector, of both bodies, and a point of each"},
      JointForm{revolute_on_slider, 2, "revolute_on_slider", 0, 2, 0, 1, 1,
                "a vector and a point of the first body, and a point of the second"},
      JointForm{fixed, 2, "fixed", 0, 0, 0, 0, 3, "no points or vectors"},
      JointForm{revolute, 3, "revolute", 1, 0, 1, 0, 5,
                "one point and one vector, the axis, of both bodies"},
      JointForm{prismatic, 3, "prismatic", 0, 2, 2, 0, 5,
                "two vectors of both bodies, first the axis, and a point of each"},
      JointForm{cylindrical, 3, "cylindrical", 0, 2, 1, 0, 4,
                "one vector, the axis, of both bodies, and a point of each"},
      JointForm{universal, 3, "universal", 1, 0, 0, 2, 4,
                "one point of both bodies, and a vector of each"},
      JointForm{spherical, 3, "spherical", 1, 0, 0, 0, 3, "one point, of both bodies"},
      JointForm{fixed, 3, "fixed", 0, 0, 0, 0, 6, "no points or vectors"},
      JointForm{hinge, 3, "hinge", 2, 0, 0, 0, 5, "two points, of both bodies"},
      JointForm{point_on_line, 3, "point_on_line", 0, 2, 0, 1, 2,
                "a vector and a point of the first body, and a point of the second"},
      JointForm{point_on_plane, 3, "point_on_plane", 0, 2, 0, 1, 1,
                "a vector and a point of the first body, and a point of the second", true},
      JointForm{planar, 3, "planar", 0, 2, 1, 0, 3,
                "one vector, the normal, of both bodies, and a point of each", true},
  };
  return table;
}

bool slides(Mechanism::JointType type) {
  return std::ranges::any_of(joint_forms(), [&](const JointForm& f) {
    return f.type == type && f.own_points > 0 && !f.in_plane;
  });
}

bool turns(Mechanism::JointType type) {
  using enum Mechanism::JointType;
  return type == revolute || type == hinge || type == cylindrical;
}

const JointForm* find_joint_form(Mechanism::JointType type, int dimension) {
  const auto form = std::ranges::find_if(joint_forms(), [&](const JointForm& f) {
    return f.type == type && f.dimension == dimension;
  });
  return form == joint_forms().end() ? nullptr : &*form;
}

}  // namespace desmo
