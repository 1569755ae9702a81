// Mechanisms and motions in which a run that is not monitored goes wrong without a word.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "cases/extremes/rows.h"
#include "cases/io/files.h"
#include "formulations/base/observer.h"
#include "formulations/constraints/constraints.h"
#include "formulations/modelling/modelling.h"
#include "tests/mechanisms.h"

namespace desmo {

/// Crank of 1 about (0, 0), rod of 3, slider on y = 0.1, driven up to its dead point at x² = 16 −
/// 0.1² but for `distance`, and back, once a second.
inline Scene driven_slider(double distance) {
  const double farthest = std::sqrt(16 - 0.01) - distance, x = (3 + farthest) / 2;
  const double reach = std::hypot(x, 0.1), along = (1 - 9 + reach * reach) / (2 * reach),
               beside = std::sqrt(1 - along * along);
  Scene scene = parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "driven_slider", "dimension": 2,
      "points": {"O": [0, 0], "A": [1, 0], "C": [4, 0.1], "P": [0, 0.1]}, "vectors": {"x": [1, 0]},
      "ground": {"points": ["O", "P"], "vectors": ["x"]},
      "bodies": {"crank": {"points": ["O", "A"], "length": 1},
                 "rod": {"points": ["A", "C"], "length": 3},
                 "slider": {"points": ["C"], "vectors": ["x"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "rod"], "points": ["A"]},
        {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
        {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"],
         "points": ["P", "C"]}],
      "coordinates": {"s": {"distance": ["P", "C"], "along": "x"}}, "drivers": ["s"]},
    "motion": {"s": {"type": "polynomial", "coefficients": [4]}},
    "time": {"end": 1, "step": 0.01}})",
                            "driven_slider.scene.json", "");
  scene.mechanism.points[1].position = {(along * x - beside * 0.1) / reach,
                                        (along * 0.1 + beside * x) / reach, 0};
  scene.mechanism.points[2].position = {x, 0.1, 0};
  scene.motions[0] = HarmonicSum{x, {{(farthest - 3) / 2, 2 * std::numbers::pi, 0}}};
  return scene;
}

/// A crank of 1 whose pin slides in a block that turns 2.5 away. Where the crank points at the
/// block, the direction of the slide has one component that is all but zero.
inline Model oscillating_block() {
  return make_model(parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "block", "dimension": 2,
      "points": {"O": [0, 0], "A": [0, 1], "D": [2.5, 0]},
      "vectors": {"u": [-2.5, 1]},
      "ground": {"points": ["O", "D"]},
      "bodies": {"crank": {"points": ["O", "A"]}, "rod": {"points": ["A"], "vectors": ["u"]},
                 "block": {"points": ["D"], "vectors": ["u"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
        {"type": "revolute", "bodies": ["crank", "rod"], "points": ["A"]},
        {"type": "prismatic", "bodies": ["block", "rod"], "vectors": ["u"],
         "points": ["D", "A"]},
        {"type": "revolute", "bodies": ["ground", "block"], "points": ["D"]}],
      "coordinates": {"theta": {"angle": ["O", "A"]}, "psi": {"angle": "u"},
                      "s": {"distance": ["D", "A"], "along": "u"}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [-0.001, 1]}},
    "time": {"end": 0.002, "step": 1e-5}})",
                                "block.scene.json", ""));
}

/// Links of a millimetre on a crank [m], at a tenth of a millimetre per second.
inline Scene small_dyad(double crank) {
  constexpr double small = 1e-3;
  return extremes::case_of(
             "small dyad",
             extremes::one_dyad(crank, small / crank, crank + small / 2, small, small),
             small / crank / 10, {0, 0.1, 11})
      .scene;
}

/// A four-bar of 60 mm on an arm.
inline Scene four_bar_on_arm(std::string_view case_name) {
  const std::vector<ExtremeCase> cases = extremes::scales(Extent::brief);
  return std::ranges::find(cases, case_name, &ExtremeCase::name)->scene;
}

/// A parallelogram with cranks of 1 whose base is 2.
inline Scene parallelogram(const Motion& crank, const TimeGrid& grid) {
  DyadChain chain{.crank = 1, .start = sample(crank, grid.start).position, .dyads = {}};
  const Mechanism::Vec pin = crank_pin(chain);
  chain.dyads = {closed_dyad(pin, {2, 0, 0}, 2, 1, -1)};
  chain.dyads[0].joint = {pin[0] + 2, pin[1], 0};
  chain.dyads[0].angle = chain.start;
  return extremes::case_of("parallelogram", {chain}, {crank}, grid).scene;
}

/// Compares the rocker with the crank, to which it is parallel.
class RockerError final : public Observer {
 public:
  explicit RockerError(const Model& m)
      : crank_(m.entities[m.find("crank/theta")].first),
        rocker_(m.entities[m.find("dyad1/psi")].first) {}
  Flow observe(const Instant& i) noexcept override {
    const auto add = [&](std::span<const double> values, double& error) {
      if (!values.empty()) error = std::max(error, std::abs(values[rocker_] - values[crank_]));
    };
    add(i.q, error.position);
    add(i.qd, error.velocity);
    add(i.qdd, error.acceleration);
    return Flow::go_on;
  }
  PerLevel<double> error{};

 private:
  int crank_, rocker_;
};

/// Keeps by how much the last instant differs from the first.
class Difference final : public Observer {
 public:
  Flow observe(const Instant& i) noexcept override {
    if (i.index == 0) first_.assign(i.q.begin(), i.q.end());
    difference = 0;
    for (std::size_t k = 0; k < first_.size(); ++k)
      difference = std::max(difference, std::abs(i.q[k] - first_[k]));
    return Flow::go_on;
  }
  double difference = INFINITY;

 private:
  std::vector<double> first_;
};

/// A parallelogram turns through its change points with rates that are as ever.
inline Model parallelogram() {
  Model m = four_bar_model(1);
  for (Constraint& c : m.constraints)
    if (c.group == 1 && c.kind == kind_index<PlanarAngle>()) c.set_dimension(0, 2);  // the rocker
  std::ranges::find(m.constraints, "dyad1/rocker: dyad1/D-dyad1/C length", &Constraint::name)
      ->constants[0] = 4;  // its length squared
  const auto at = [&](const char* name) { return m.entities[m.find(name)].first; };
  m.estimate[at("dyad1/C")] = 7;
  m.estimate[at("dyad1/C") + 1] = std::sqrt(3.0);
  m.estimate[at("dyad1/psi")] = std::numbers::pi / 3;
  return m;
}

}  // namespace desmo
