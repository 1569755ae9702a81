// Dimensions that are small beside the mechanism count as the file has them.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/float128.hpp>
#include <cmath>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "tests/checked/rows.h"

namespace desmo::small_dimensions_test {
namespace {

using Wide = boost::multiprecision::float128;
using Place = std::array<double, 3>;

/// A body that turns about the z axis at 1 rad/s, from where it is drawn: O in the origin, B in
/// y = 0, so that the drawing is at 0 rad.
Model turning_body(const Place& b, const std::vector<Place>& others, double off_axis) {
  std::string points = R"("O": [0, 0, 0], "B": )", names = R"("O", "B")";
  const auto text = [](const Place& p) {
    return formatted("[%.17g, %.17g, %.17g]", p[0], p[1], p[2]);
  };
  points += text(b);
  for (std::size_t k = 0; k < others.size(); ++k) {
    const std::string name = "\"P" + std::to_string(k) + '"';
    points += ", " + name + ": " + text(others[k]);
    names += ", " + name;
  }
  return make_model(parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "turning", "dimension": 3,
      "points": {)" + points + R"(},
      "vectors": {"x": [1, 0, 0], "y": [0, 1, 0], "z": [0, 0, 1], "w": [0, )" +
                                    formatted("%.17g", off_axis) + R"(, 1]},
      "ground": {"points": ["O"], "vectors": ["x", "y", "z"]},
      "bodies": {"plate": {"points": [)" +
                                    names + R"(], "vectors": ["z", "w"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "plate"], "points": ["O"],
                  "vectors": ["z"]}],
      "coordinates": {"theta": {"angle": ["O", "B"], "from": "x", "towards": "y"}},
      "drivers": ["theta"]},
    "motion": {"theta": {"type": "polynomial", "coefficients": [0, 1]}}, "time": {"at": 0}})",
                                "turning.scene.json", ""));
}

/// Expects every row to be proven, and what was drawn at a place to be there, turned by t.
void expect_turned(const Model& m, const std::vector<std::pair<std::string, Place>>& drawn,
                   double step) {
  const CheckedRows run = solve_checked(m, {0, step, 8}, "block_automatic_eigen");
  ASSERT_EQ(run.rows.size(), 8u);
  for (const CheckedRow& row : run.rows) {
    ASSERT_FALSE(row.flag) << row.time;
    const Wide c = cos(Wide(row.time)), s = sin(Wide(row.time));
    for (const auto& [name, p] : drawn) {
      const Entity& e = m.entities[m.find(name)];
      const Wide x(p[0]), y(p[1]), z(p[2]),
          norm = e.kind == EntityKind::vector ? sqrt(x * x + y * y + z * z) : Wide(1);
      const std::array<Wide, 3> exact{(c * x - s * y) / norm, (s * x + c * y) / norm, z / norm};
      for (int i = 0; i < 3; ++i)
        EXPECT_LE(abs(row.values.position[e.first + i] - exact[i]),
                  row.radius.position[e.first + i])
            << name << i << " at " << row.time;
    }
  }
}

TEST(SmallDimensions, OffThePlaneOfABodyCount) {
  for (const double off : {0.3, 1e-2, 1e-4, 9e-6, 2e-6, 9e-7, 1e-10, 1e-13, -1e-14}) {
    const Place a{0.2, off, 1};
    const Model m = turning_body({1, 0, 0}, {a}, off);
    for (const double step : {0.17, 1.0}) expect_turned(m, {{"P0", a}, {"w", {0, off, 1}}}, step);
  }
}

TEST(SmallDimensions, OfPlatesThatAreTypedWithFewDigitsCount) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> place(-100, 100);
  for (const double last : {1e-3, 1e-4, 1e-6}) {
    const double tilt = place(random);
    std::vector<Place> corners;
    std::vector<std::pair<std::string, Place>> drawn;
    for (int k = 0; k < 3; ++k) {
      Place p{place(random), 0, place(random)};
      p[1] = 0.3 * p[0] + tilt / 100 * p[2];  // a plane through O, but for the digits
      for (double& x : p) x = std::round(x / last) * last;
      corners.push_back(p);
      drawn.emplace_back("P" + std::to_string(k), p);
    }
    expect_turned(turning_body({50, 0, 0}, corners, 0), drawn, 0.17);
  }
}

}  // namespace
}  // namespace desmo::small_dimensions_test
