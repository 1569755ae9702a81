// A mechanism for whose groups desmo was built without generated code.
#pragma once

#include <array>
#include <string>

#include "cases/mechanism/formatted.h"
#include "tests/replaced.h"

namespace desmo {

/// Returns a scene with `copies` independent linkages: a crank moves a plate on two more links, and
/// the plate moves a slider by a rod. rest: further members of the scene.
inline std::string swinging_plates(int copies, const std::string& rest) {
  std::string points, ground, bodies, joints, coordinates, drivers, motion;
  for (int i = 0; i < copies; ++i) {
    // Adds members to a list; ~ begins each name of this linkage.
    const auto add = [&](std::string& list, const std::string& members) {
      const std::string prefix = {static_cast<char>('a' + i), '/'};
      list += (list.empty() ? "" : ", ") + replaced_everywhere(members, "~", prefix);
    };
    add(points, R"("~O": [0, 0], "~P": [1, 0], "~G": [8, 0], "~H": [9, 5], "~Q1": [3, 2],
        "~Q2": [6, 2], "~Q3": [4.5, )" +
                    std::to_string(4.5 + 0.1 * i) +
                    R"(], "~R": [5, 3], "~K": [5, -6], "~S": [5, -3])");
    add(ground, R"("~O", "~G", "~H", "~K")");
    add(bodies, R"("~crank": {"points": ["~O", "~P"]}, "~link1": {"points": ["~P", "~Q1"]},
        "~link2": {"points": ["~G", "~Q2"]}, "~link3": {"points": ["~H", "~Q3"]},
        "~plate": {"points": ["~Q1", "~Q2", "~Q3", "~R"]}, "~rod": {"points": ["~R", "~S"]},
        "~slider": {"points": ["~S"], "vectors": ["y"]})");
    for (const auto& [first, second, at] : {std::array{"ground", "~crank", "~O"},
                                            {"~crank", "~link1", "~P"},
                                            {"ground", "~link2", "~G"},
                                            {"ground", "~link3", "~H"},
                                            {"~link1", "~plate", "~Q1"},
                                            {"~link2", "~plate", "~Q2"},
                                            {"~link3", "~plate", "~Q3"},
                                            {"~plate", "~rod", "~R"},
                                            {"~rod", "~slider", "~S"}})
      add(joints, formatted(R"({"type": "revolute", "bodies": ["%s", "%s"], "points": ["%s"]})",
                            first, second, at));
    add(joints, R"({"type": "prismatic", "bodies": ["ground", "~slider"], "vectors": ["y"],
        "points": ["~K", "~S"]})");
    add(coordinates, R"("~theta": {"angle": ["~O", "~P"]}, "~beta": {"angle": ["~Q1", "~Q2"]},
        "~s": {"distance": ["~K", "~S"], "along": "y"})");
    add(drivers, R"("~theta")");
    add(motion,
        formatted(R"("~theta": {"type": "polynomial", "coefficients": [-10, %d]})", 30 + i));
  }
  return R"({"format": "desmo-scene", "version": 1, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "plates", "title": "$(touch pwned) */ \" \\",
    "dimension": 2, "units": {"length": "1", "angle": "deg"},
    "points": {)" +
         points + R"(}, "vectors": {"y": [0, 1]}, "ground": {"points": [)" + ground +
         R"(], "vectors": ["y"]}, "bodies": {)" + bodies + R"(}, "joints": [)" + joints +
         R"(], "coordinates": {)" + coordinates + R"(}, "drivers": [)" + drivers + R"(]},
    "units": {"angle": "deg"}, "motion": {)" +
         motion + "}" + rest + "}";
}

/// The time grid of one second, as a member of the scene.
inline const std::string one_second = R"(, "time": {"end": 1, "step": 0.01})";

}  // namespace desmo
