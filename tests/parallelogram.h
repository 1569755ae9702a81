#pragma once

#include <string>

namespace desmo {

/// The file of a parallelogram that turns from 100° to 260°; branches meet at 180°, which no
/// instant hits.
inline const std::string parallelogram_scene = R"({
  "format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "parallelogram", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"A": [0, 0], "B": [0, 1], "C": [2, 1], "D": [2, 0]},
    "ground": {"points": ["A", "D"]},
    "bodies": {"crank": {"points": ["A", "B"]}, "rod": {"points": ["B", "C"]},
               "rocker": {"points": ["C", "D"]}},
    "joints": [
      {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
      {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
      {"type": "revolute", "bodies": ["rod", "rocker"], "points": ["C"]},
      {"type": "revolute", "bodies": ["rocker", "ground"], "points": ["D"]}],
    "coordinates": {"theta": {"angle": ["A", "B"]}}, "drivers": ["theta"]},
  "motion": {"theta": {"type": "polynomial", "coefficients": [100, 160]}},
  "time": {"end": 1, "step": 0.04},
  "request": [{"points": ["C"], "level": "acceleration"}]})";

}  // namespace desmo
