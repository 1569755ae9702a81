#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/io/files.h"
#include "formulations/base/observer.h"
#include "formulations/model/model.h"

namespace desmo {

/// Returns a Scott Russell linkage: crank OM = 1 and bar C–M–T with MC = MT = 1; C slides on the x
/// axis through O. The crank turns from 30° to 180° at 30°/s, so that C is at x = 2 cos θ. At 90°
/// (t = 2 s) C meets O: a change point, from which on C could also rest at O. step: [s].
inline Scene scott_russell(double step) {
  Scene scene = parse_scene(R"({
    "format": "desmo-scene", "version": 1,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "scott_russell", "dimension": 2,
      "units": {"angle": "deg"},
      "points": {"O": [0, 0], "M": [0.8660254037844387, 0.5], "C": [1.7320508075688774, 0],
                 "T": [0, 1]},
      "vectors": {"x": [1, 0]},
      "ground": {"points": ["O"], "vectors": ["x"]},
      "bodies": {"crank": {"points": ["O", "M"]}, "bar": {"points": ["C", "M", "T"]},
                 "slider": {"points": ["C"], "vectors": ["x"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "bar"], "points": ["M"]},
        {"type": "revolute", "bodies": ["bar", "slider"], "points": ["C"]},
        {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"],
         "points": ["O", "C"]}],
      "coordinates": {"theta": {"angle": ["O", "M"]},
                      "s": {"distance": ["O", "C"], "along": "x"}},
      "drivers": ["theta"]},
    "units": {"angle": "deg"},
    "motion": {"theta": {"type": "polynomial", "coefficients": [30, 30]}},
    "time": {"end": 5, "step": 1}})",
                            "scott_russell.scene.json", "");
  scene.grid = {0, step, static_cast<int>(5 / step + 1.5)};
  return scene;
}

/// Compares C of the Scott Russell linkage with x = 2 cos θ.
class SliderError final : public Observer {
 public:
  explicit SliderError(const Model& m) : first_(m.entities[m.find("C")].first) {}
  Flow observe(const Instant& i) noexcept override {
    const double theta = (30 + 30 * i.time) * std::numbers::pi / 180, rate = std::numbers::pi / 6;
    const bool is_there = std::abs(i.time - 2) < 1e-9;
    double& error = is_there ? there : elsewhere;
    error = std::max(error, std::abs(i.q[first_] - 2 * std::cos(theta)));
    if (!i.qd.empty()) error = std::max(error, std::abs(i.qd[first_] + 2 * rate * std::sin(theta)));
    if (!i.qdd.empty())
      error = std::max(error, std::abs(i.qdd[first_] + 2 * rate * rate * std::cos(theta)));
    return Flow::go_on;
  }
  double there = 0, elsewhere = 0;

 private:
  int first_;
};

}  // namespace desmo
