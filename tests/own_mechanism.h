// A mechanism for whose groups desmo was built without generated code.
#pragma once

#include <string>

namespace desmo {

/// Returns a scene with `copies` independent linkages: a crank moves a plate on two more links, and
/// the plate moves a slider by a rod. rest: further members of the scene.
inline std::string swinging_plates(int copies, const std::string& rest) {
  std::string points, ground, bodies, joints, coordinates, drivers, motion;
  for (int i = 0; i < copies; ++i) {
    const std::string p = std::string(1, static_cast<char>('a' + i)) + "/", comma = i ? "," : "";
    const auto name = [&](const std::string& n) { return "\"" + p + n + "\""; };
    const auto pair = [&](const std::string& a, const std::string& b) {
      return "[" + name(a) + "," + name(b) + "]";
    };
    const auto revolute = [&](const std::string& a, const std::string& b, const std::string& at) {
      const std::string first = a == "ground" ? "\"ground\"" : name(a);
      return R"({"type": "revolute", "bodies": [)" + first + "," + name(b) + R"(], "points": [)" +
             name(at) + "]},";
    };
    points += comma + name("O") + ": [0, 0]," + name("P") + ": [1, 0]," + name("G") + ": [8, 0]," +
              name("H") + ": [9, 5]," + name("Q1") + ": [3, 2]," + name("Q2") + ": [6, 2]," +
              name("Q3") + ": [4.5, " + std::to_string(4.5 + 0.1 * i) + "]," + name("R") +
              ": [5, 3]," + name("K") + ": [5, -6]," + name("S") + ": [5, -3]";
    ground += comma + name("O") + "," + name("G") + "," + name("H") + "," + name("K");
    bodies += comma + name("crank") + R"(: {"points": )" + pair("O", "P") + "}," + name("link1") +
              R"(: {"points": )" + pair("P", "Q1") + "}," + name("link2") + R"(: {"points": )" +
              pair("G", "Q2") + "}," + name("link3") + R"(: {"points": )" + pair("H", "Q3") + "}," +
              name("plate") + R"(: {"points": [)" + name("Q1") + "," + name("Q2") + "," +
              name("Q3") + "," + name("R") + "]}," + name("rod") + R"(: {"points": )" +
              pair("R", "S") + "}," + name("slider") + R"(: {"points": [)" + name("S") +
              R"(], "vectors": ["y"]})";
    joints += revolute("ground", "crank", "O") + revolute("crank", "link1", "P") +
              revolute("ground", "link2", "G") + revolute("ground", "link3", "H") +
              revolute("link1", "plate", "Q1") + revolute("link2", "plate", "Q2") +
              revolute("link3", "plate", "Q3") + revolute("plate", "rod", "R") +
              revolute("rod", "slider", "S") + R"({"type": "prismatic", "bodies": ["ground",)" +
              name("slider") + R"(], "vectors": ["y"], "points": )" + pair("K", "S") + "}" +
              (i + 1 < copies ? "," : "");
    coordinates += comma + name("theta") + R"(: {"angle": )" + pair("O", "P") + "}," +
                   name("beta") + R"(: {"angle": )" + pair("Q1", "Q2") + "}," + name("s") +
                   R"(: {"distance": )" + pair("K", "S") + R"(, "along": "y"})";
    drivers += comma + name("theta");
    motion += comma + name("theta") + R"(: {"type": "polynomial", "coefficients": [-10, )" +
              std::to_string(30 + i) + "]}";
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
