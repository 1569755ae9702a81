// Valid mechanism and scene files, changes to them, and the readers' error messages.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "cases/io/files.h"
#include "tests/contains.h"
#include "tests/refusal.h"
#include "tests/replaced.h"

namespace desmo {

inline const std::string slider_crank = R"({
  "format": "desmo-mechanism",
  "version": 1,
  "name": "slider_crank",
  "dimension": 2,
  "units": {"length": "mm", "angle": "deg"},
  "points": {"A": [0, 0], "B": [50, 0], "C": [200, 0]},
  "vectors": {"x": [2, 0]},
  "ground": {"points": ["A"], "vectors": ["x"]},
  "bodies": {
    "crank": {"points": ["A", "B"]},
    "rod": {"points": ["B", "C"], "length": 150},
    "slider": {"points": ["C"], "vectors": ["x"]}
  },
  "joints": [
    {"name": "J1", "type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
    {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
    {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
    {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"], "points": ["A", "C"]}
  ],
  "coordinates": {
    "theta": {"angle": ["A", "B"], "estimate": 10},
    "s": {"distance": ["A", "C"], "along": "x", "estimate": 201}
  },
  "drivers": ["theta"]
})";

// A crank on a revolute joint and a rod on a spherical joint. Its vectors are defined in every way
// that a spatial file allows.
inline const std::string spatial = R"({
  "format": "desmo-mechanism",
  "version": 1,
  "name": "spatial",
  "dimension": 3,
  "points": {"A": [0, 0, 0], "B": [1, 0, 0], "C": [2, 1, 0]},
  "vectors": {
    "w": {"normal": ["v", "u"]},
    "v": {"normal": ["u", ["A", "B"]]},
    "u": [0, 0, 1],
    "r": {"along": ["B", "C"]}
  },
  "ground": {"points": ["A"], "vectors": ["u", "v", "w"]},
  "bodies": {
    "crank": {"points": ["A", "B"], "vectors": ["u"]},
    "rod": {"points": ["B", "C"], "vectors": ["r"]}
  },
  "joints": [
    {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"], "vectors": ["u"]},
    {"type": "spherical", "bodies": ["crank", "rod"], "points": ["B"]}
  ],
  "coordinates": {
    "theta": {"angle": ["A", "B"], "from": "-w", "towards": "v"},
    "z": {"component": "C", "axis": "z"}
  },
  "drivers": ["theta"]
})";

/// A crank of 3 and 4 and a slider, with coordinates of all kinds; `driver` is driven.
inline std::string drawn(const std::string& driver) {
  return R"({"format": "desmo-mechanism", "version": 1, "name": "drawn", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"A": [1, 2], "B": [4, 6], "C": [9, 2]}, "vectors": {"u": [3, 1]},
    "ground": {"points": ["A"], "vectors": ["u"]},
    "bodies": {"crank": {"points": ["A", "B"]}, "rod": {"points": ["B", "C"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
               {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]}],
    "coordinates": {"angle": {"angle": ["A", "B"], "estimate": 370},
                    "turn": {"angle": ["C", "B"], "from": "u"},
                    "distance": {"distance": ["A", "B"]}, "diagonal": {"distance": ["B", "C"]},
                    "along": {"distance": ["A", "C"], "along": "u"},
                    "height": {"component": "B", "axis": "y"}},
    "drivers": [")" +
         driver + "\"]}";
}

inline std::string scene_of(const std::string& mechanism, const std::string& members) {
  return R"({"format": "desmo-scene", "version": 2, "mechanism": )" + mechanism +
         (members.empty() ? "" : ", ") + members + "}";
}

inline const std::string motion =
    R"("motion": {"theta": {"type": "polynomial", "coefficients": [0, 360]}})";
inline const std::string time_of_one_second = R"("time": {"end": 1, "step": 0.01})";
inline const std::string driven = motion + ", " + time_of_one_second;

inline std::string mechanism_complaint(const std::string& text) {
  return refusal<InputError>([&] { parse_mechanism(text, "m.json"); });
}

inline std::string scene_complaint(const std::string& text) {
  return refusal<InputError>([&] { parse_scene(text, "s.json", ""); });
}

inline void expect_start(const std::string& message, const std::string& start) {
  EXPECT_EQ(message.substr(0, start.size()), start) << message;
}

/// A replacement in a valid file, with the beginning of the error message that it causes.
struct Change {
  std::string old, by, message;
};

}  // namespace desmo
