// Distances of points that all but meet: their whole equation vanishes there, though no unknown
// moves fast.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "cases/io/files.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/monitor/monitored_run.h"

namespace desmo::near_meetings_test {
namespace {

/// Slider-crank of 1 and 3, whose slider passes the point G, `gap` before 2.
Scene slider(double gap) {
  return parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "passing_slider", "dimension": 2,
      "points": {"A": [0, 0], "B": [0.955336489125606, 0.29552020666133955],
                 "C": [3.9407456415626454, 0], "G": [)" +
                         std::to_string(2 - gap) + R"(, 0]},
      "vectors": {"x": [1, 0]},
      "ground": {"points": ["A", "G"], "vectors": ["x"]},
      "bodies": {"crank": {"points": ["A", "B"], "length": 1},
                 "rod": {"points": ["B", "C"], "length": 3},
                 "slider": {"points": ["C"], "vectors": ["x"]}},
      "joints": [
        {"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
        {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
        {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
        {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"],
         "points": ["A", "C"]}],
      "coordinates": {"theta": {"angle": ["A", "B"]}, "g": {"distance": ["G", "C"]}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [0.3, 6.283185307179586]}},
    "time": {"end": 1, "step": 0.001}})",
                     "passing_slider.scene.json", "");
}

/// Boom of 1 about (0, 0) on a rope of length s to (1, 0), which is drawn in to 1e-4.
Scene boom() {
  return parse_scene(R"({
    "format": "desmo-scene", "version": 2,
    "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "boom", "dimension": 2,
      "points": {"O": [0, 0], "D": [1, 0], "B": [0.74130260521419, 0.6711709525170578]},
      "ground": {"points": ["O", "D"]}, "bodies": {"boom": {"points": ["O", "B"], "length": 1}},
      "joints": [{"type": "revolute", "bodies": ["ground", "boom"], "points": ["O"]}],
      "coordinates": {"s": {"distance": ["D", "B"]}, "th": {"angle": ["O", "B"]}},
      "drivers": ["s"]},
    "motion": {"s": {"type": "harmonic", "mean": 0.6001,
                     "terms": [{"amplitude": 0.6, "frequency": 1, "phase": 0.2}]}},
    "time": {"end": 1, "step": 0.001}})",
                     "boom.scene.json", "");
}

int coordinate(const Model& m, const std::string& name) {
  return std::ranges::find(m.entities, name, &Entity::name)->first;
}

/// Largest error of a coordinate, as a function of an instant says.
template <class Error>
class Largest final : public Observer {
 public:
  explicit Largest(Error error) : error_(std::move(error)) {}
  Flow observe(const Instant& instant) noexcept override {
    largest = std::max(largest, error_(instant));
    return Flow::go_on;
  }

  double largest = 0;

 private:
  Error error_;
};

template <class Error>
double largest_error(const Scene& scene, const Model& m, const std::string& id, Error error) {
  const Configuration c = parse_id(id);
  Largest<Error> observer(std::move(error));
  const MonitoredSummary s = run_monitored(*make_formulation(*c.variant, m, c.settings), scene.grid,
                                           {Level::acceleration}, observer);
  return s.outcome() == Outcome::converged ? observer.largest : 0;
}

const std::string ids[] = {"block_symbolic_inlined", "block_symbolic_explicit",
                           "block_automatic_lapack", "block_automatic_klu/guess:hermite5",
                           "group_automatic_klu"};

/// The position converges to 1e-10 of a size of 4.
constexpr double promised = 4e-10;

TEST(NearMeetings, OfASliderAndAPointAreRightOrFlagged) {
  for (const double gap : {1e-6, 1e-5, 1e-4, 1e-3, 1e-2}) {
    const Scene scene = slider(gap);
    const Model m = make_model(scene);
    const int g = coordinate(m, "g"), x = coordinate(m, "C");
    for (const std::string& id : ids)
      EXPECT_LE(largest_error(scene, m, id,
                              [&](const Instant& i) {
                                return std::abs(i.q[g] - std::abs(i.q[x] - (2 - gap)));
                              }),
                promised)
          << id << " with a gap of " << gap;
  }
}

TEST(NearMeetings, OfABoomAndItsRopeAreRightOrFlagged) {
  const Scene scene = boom();
  const Model m = make_model(scene);
  const int s = coordinate(m, "s"), th = coordinate(m, "th");
  for (const std::string& id : ids)
    EXPECT_LE(largest_error(
                  scene, m, id,
                  [&](const Instant& i) { return std::abs(i.q[th] - 2 * std::asin(i.q[s] / 2)); }),
              promised)
        << id;
}

}  // namespace
}  // namespace desmo::near_meetings_test
