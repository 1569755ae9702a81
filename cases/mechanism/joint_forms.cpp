#include "cases/mechanism/joint_forms.h"

#include <algorithm>

namespace desmo {

std::span<const JointForm> joint_forms() {
  using enum Mechanism::JointType;
  // clang-format off
  static constexpr JointForm table[]{
      {.type = revolute, .dimension = 2, .name = "revolute", .freedoms_removed = 2,
       .common_points = 1, .takes = "one point, of both bodies"},
      {.type = prismatic, .dimension = 2, .name = "prismatic", .freedoms_removed = 2,
       .own_points = 2, .common_vectors = 1,
       .takes = "one vector, of both bodies, and a point of each"},
      {.type = revolute_on_slider, .dimension = 2, .name = "revolute_on_slider",
       .freedoms_removed = 1, .own_points = 2, .own_vectors = 1,
       .takes = "a vector and a point of the first body, and a point of the second"},
      {.type = fixed, .dimension = 2, .name = "fixed", .freedoms_removed = 3,
       .takes = "no points or vectors"},
      {.type = revolute, .dimension = 3, .name = "revolute", .freedoms_removed = 5,
       .common_points = 1, .common_vectors = 1,
       .takes = "one point and one vector, the axis, of both bodies"},
      {.type = prismatic, .dimension = 3, .name = "prismatic", .freedoms_removed = 5,
       .own_points = 2, .common_vectors = 2,
       .takes = "two vectors of both bodies, first the axis, and a point of each"},
      {.type = cylindrical, .dimension = 3, .name = "cylindrical", .freedoms_removed = 4,
       .own_points = 2, .common_vectors = 1,
       .takes = "one vector, the axis, of both bodies, and a point of each"},
      {.type = universal, .dimension = 3, .name = "universal", .freedoms_removed = 4,
       .common_points = 1, .own_vectors = 2,
       .takes = "one point of both bodies, and a vector of each"},
      {.type = spherical, .dimension = 3, .name = "spherical", .freedoms_removed = 3,
       .common_points = 1, .takes = "one point, of both bodies"},
      {.type = fixed, .dimension = 3, .name = "fixed", .freedoms_removed = 6,
       .takes = "no points or vectors"},
      {.type = hinge, .dimension = 3, .name = "hinge", .freedoms_removed = 5,
       .common_points = 2, .takes = "two points, of both bodies"},
      {.type = point_on_line, .dimension = 3, .name = "point_on_line", .freedoms_removed = 2,
       .own_points = 2, .own_vectors = 1,
       .takes = "a vector and a point of the first body, and a point of the second"},
      {.type = point_on_plane, .dimension = 3, .name = "point_on_plane", .freedoms_removed = 1,
       .own_points = 2, .own_vectors = 1, .in_plane = true,
       .takes = "a vector and a point of the first body, and a point of the second"},
      {.type = planar, .dimension = 3, .name = "planar", .freedoms_removed = 3,
       .own_points = 2, .common_vectors = 1, .in_plane = true,
       .takes = "one vector, the normal, of both bodies, and a point of each"},
  };
  // clang-format on
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
