// Flaps on a hinge of the ground, whose own shape does not quite fit it.
#pragma once

#include <string>

#include "cases/mechanism/formatted.h"

namespace desmo {

/// Returns a scene of flaps on one hinge of 0.4 m, each opened by a driver of its own: the first to
/// F1. Their own points on the hinge are farther apart than those of the ground.
inline std::string flaps(int count, double farther) {
  std::string bodies, joints, angles, drivers, motions;
  for (int i = 1; i <= count; ++i) {
    const std::string n = std::to_string(i), comma = i > 1 ? ", " : "";
    bodies += comma + R"("flap)" + n + R"(": {"at": [0, 0, 0, 0, 0, 0], "points": {
        "H": [0, 0, 0], "K": [0, )" +
              formatted("%.17g", 0.4 + farther) + R"(, 0], "F)" + n + R"(": [0.3, 0, 0]}})";
    joints += comma + R"({"type": "hinge", "bodies": ["ground", "flap)" + n +
              R"("], "points": ["H", "K"]})";
    angles += comma + R"("open)" + n + R"(": {"angle": ["H", "F)" + n +
              R"("], "from": "x", "towards": "z"})";
    drivers += comma + R"("open)" + n + '"';
    motions += comma + R"("open)" + n + R"(": {"type": "polynomial", "coefficients": [0, 1]})";
  }
  return R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "flaps", "dimension": 3,
      "points": {"H": [0, 0, 0], "K": [0, 0.4, 0]}, "vectors": {"x": [1, 0, 0], "z": [0, 0, 1]},
      "ground": {"points": ["H", "K"], "vectors": ["x", "z"]}, "bodies": {)" +
         bodies + R"(}, "joints": [)" + joints + R"(], "coordinates": {)" + angles +
         R"(}, "drivers": [)" + drivers + R"(]}, "motion": {)" + motions +
         R"(}, "time": {"end": 1, "step": 0.1}})";
}

}  // namespace desmo
