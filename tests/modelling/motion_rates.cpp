// Rates that formulations deliver for motions as people describe them, against differences of
// positions of a quadruple reference.

#include <gtest/gtest.h>

#include <cmath>
#include <ostream>
#include <string>

#include "cases/io/files.h"
#include "tests/formulated.h"
#include "tests/modelling/differences.h"
#include "tests/started.h"

namespace desmo::motion_rates_test {
namespace {

struct Described {
  const char* name;
  const char* motion;  ///< of a crank's angle, in degrees
  const char* time = R"("start": 0.125, "end": 0.875, "step": 0.25)";
};

void PrintTo(const Described& described, std::ostream* out) { *out << described.name; }

class RatesOfAMotion : public InFolder, public testing::WithParamInterface<Described> {};

TEST_P(RatesOfAMotion, AreDifferencesOfPositions) {
  write("crank.csv", "t,theta\n0,0\n0.3,40\n0.7,-30\n1,90\n");
  const Scene scene =
      parse_scene(std::string(R"({"format": "desmo-scene", "version": 2, "mechanism": {"library":
          "slider_crank"}, "motion": {"theta": {)") +
                      GetParam().motion + R"(}}, "time": {)" + GetParam().time + "}}",
                  "scene.json", folder_);
  const Model m = make_model(scene);
  const auto f = formulated("group_automatic_lapack", m, {.tolerance = 1e-13});
  for (int i = 0; i < scene.grid.instants; ++i) {
    const double t = scene.grid.time(i);
    SCOPED_TRACE(t);
    const Summary summary = f->step(t);
    ASSERT_TRUE(summary.ok()) << describe(summary, m);
    const Differences exact(m, t);
    for (const char* name : {"theta", "s", "B.y", "C.x"}) {
      const auto expect = [&](Level level, int order, double tolerance) {
        const double right = exact(name, order);
        EXPECT_NEAR(f->value(name, level), right, tolerance * std::max(1., std::abs(right)))
            << name;
      };
      expect(Level::velocity, 1, 1e-11);
      expect(Level::acceleration, 2, 1e-9);
    }
  }
}

INSTANTIATE_TEST_SUITE_P(
    Table, RatesOfAMotion,
    testing::Values(
        Described{"polynomial",
                  R"("type": "polynomial", "from": "drawing", "coefficients": [5, 90, 40, -60])"},
        Described{"harmonic", R"("type": "harmonic", "from": "drawing", "mean": 20,
            "terms": [{"amplitude": 50, "frequency": 2, "phase": 30}])"},
        Described{"speed", R"("type": "speed", "value": 40, "acceleration": -25, "unit": "rpm")"},
        // Runs up until 0.25 s, is steady until 0.5 s, and rests from 0.75 s on.
        Described{"trapezoid",
                  R"("type": "trapezoid", "by": 100, "velocity": 200, "acceleration": 800)"},
        Described{"rows_of_a_file", R"("type": "table", "file": "crank.csv")"},
        // A single instant with z, its rate and its acceleration.
        Described{"single_instant",
                  R"("type": "speed", "from": 40, "value": 500, "acceleration": -2000)",
                  R"("at": 0)"}),
    [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace desmo::motion_rates_test
