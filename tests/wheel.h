// A crank and a wheel that are coupled by tables.
#pragma once

#include <span>
#include <string>

#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"

namespace desmo {

/// Crank a and wheel w [°], of which one is driven from 0 at 40° a second.
struct Wheel {
  std::string couplings, driver = "a";
  double start = 0, speed = 40, end = 1, step = 0.1;

  /// Returns the file of the scene.
  std::string text() const {
    return R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "wheel", "dimension": 2,
    "units": {"angle": "deg"},
    "points": {"O": [0, 0], "A": [1, 0], "W": [3, 0], "B": [4, 0]},
    "ground": {"points": ["O", "W"]},
    "bodies": {"crank": {"points": ["O", "A"]}, "wheel": {"points": ["W", "B"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
               {"type": "revolute", "bodies": ["ground", "wheel"], "points": ["W"]}],
    "coordinates": {"a": {"angle": ["O", "A"]}, "w": {"angle": ["W", "B"]}},
    "couplings": {)" +
           couplings + R"(}, "drivers": [")" + driver + R"("]},
  "motion": {")" +
           driver + R"(": {"type": "polynomial", "coefficients": [)" + std::to_string(start) +
           ", " + std::to_string(speed) + R"(]}},
  "time": {"end": )" +
           std::to_string(end) + R"(, "step": )" + std::to_string(step) + "}}";
  }
  Scene scene() const { return parse_scene(text(), "wheel", ""); }
};

/// Returns a coupling of the wheel to the crank, as a file has it.
inline std::string coupling_table(const std::string& name, std::span<const double> at,
                                  std::span<const double> values,
                                  const std::string& ends = "natural") {
  const auto list = [](std::span<const double> numbers) {
    std::string text;
    for (const double x : numbers) text += (text.empty() ? "" : ", ") + formatted("%.17g", x);
    return "[" + text + "]";
  };
  return "\"" + name + R"(": {"coordinate": "w", "of": "a", "at": )" + list(at) +
         R"(, "values": )" + list(values) + R"(, "ends": ")" + ends + "\"}";
}

}  // namespace desmo
