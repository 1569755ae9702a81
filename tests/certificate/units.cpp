// Lengths of a file in millimetres, which metres round, next to a dead point.

#include <gtest/gtest.h>

#include <algorithm>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <string>

#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/certificate/refinement.h"
#include "tests/certificate/containment.h"

namespace desmo::units_test {
namespace {

using Wide = boost::multiprecision::float128;

const Wide pivot = 12.7, crank = Wide(62.8) - pivot, left = -1.9;

/// A crank that is longer than its rod, on a slider: it locks where its pin is a rod's length from
/// the line. rod: its shape. head: where the rod's head is drawn
Scene scene_with(const std::string& rod, const std::string& head, double angle) {
  return parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "millimetres", "dimension": 2,
      "units": {"length": "mm", "angle": "rad"},
      "points": {"G": [-1.9, 3.3], "A": [12.7, 3.3], "B": [62.8, 3.3], "C": )" +
                         head + R"(},
      "vectors": {"x": [1, 0]},
      "ground": {"points": ["G", "A"], "vectors": ["x"]},
      "bodies": {"crank": {"points": ["A", "B"]}, "rod": )" +
                         rod + R"(, "slider": {"points": ["C"], "vectors": ["x"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "crank"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["crank", "rod"], "points": ["B"]},
                 {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
                 {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"],
                  "points": ["G", "C"]}],
      "coordinates": {"theta": {"angle": ["A", "B"]}, "s": {"distance": ["G", "C"], "along": "x"}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "constant", "value": )" +
                         std::to_string(angle) + R"(}}, "time": {"at": 0}})",
                     "millimetres.scene.json", "");
}

TEST(Units, OfLengthsAddNothingToAnError) {
  const double locks = std::asin(30.7 / 50.1);
  struct Rod {
    const char *shape, *head;
    Wide length;
  };
  for (const auto& [shape, head, rod] :
       {Rod{R"({"points": ["B", "C"]})", "[93.5, 3.3]", Wide(93.5) - 62.8},
        Rod{R"({"points": ["B", "C"], "length": 30.7})", "[90, 3.3]", 30.7},
        Rod{R"({"at": [62.8, 3.3, 0], "points": {"B": [0, 0], "C": [30.7, 0]}})", "[93.5, 3.3]",
            30.7}}) {
    double largest = 0;
    for (const double before : {0.3, 0.1, 1e-2, 1e-3, 1e-4, 1e-5}) {
      const Model m = make_model(scene_with(shape, head, locks - before));
      const double time = 0, theta = sample(m.drivers[0].motion, time).position;
      const ReferenceInstant s = double_solution(m, std::span(&time, 1)).front();
      Refinement refinement(m);
      const RefinedInstant& r = refinement.refine(instant_of(s));
      ASSERT_TRUE(r.proven) << before;
      const Wide above = crank * sin(Wide(theta));
      const Wide exact = pivot - left + crank * cos(Wide(theta)) + sqrt(rod * rod - above * above);
      const int i = m.coordinate("s");
      const Wide error = abs(Wide(r.instant.q[i]) - exact * Wide(1e-3));  // the unit, rounded
      EXPECT_LE(error, r.radius.position[i]) << shape << before;
      largest = std::max(largest, static_cast<double>(error) / r.radius.position[i]);
    }
    EXPECT_GT(largest, 0.01) << shape;
  }
}

}  // namespace
}  // namespace desmo::units_test
