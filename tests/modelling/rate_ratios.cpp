// Ratios of rates where one of them or both vanish: limits, or no number.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "formulations/model/scales.h"
#include "tests/modelling/measures.h"

namespace desmo::measures_test {
namespace {

TEST(Measures, RatiosAtRestAreLimitsOrMissing) {
  const Scene s = scene(slider_crank, turning, R"({"ratios": {"r": ["s", "theta"]}},
                                                  {"distances": ["s"]})");
  const Model m = make_model(s);
  Measures measures(s, m);
  const auto theta = static_cast<std::size_t>(m.coordinate("theta")),
             out = static_cast<std::size_t>(m.coordinate("s"));
  const std::vector<double> q = m.estimate;
  const double magnitude = nominal_magnitudes(m)[out];
  const auto ratio = [&](const char* over, double s_d, double theta_d, double s_dd,
                         double theta_dd) {
    Scene asked = s;
    if (over == std::string("theta/s")) asked.measures[0].of = {"theta", "s"};
    Measures found(asked, m);
    std::vector<double> qd(q.size()), qdd(q.size());
    qd[theta] = theta_d, qd[out] = s_d, qdd[theta] = theta_dd, qdd[out] = s_dd;
    const double value = found.extend({0, 0, q, qd, qdd}).qd[q.size()];
    return value;
  };
  EXPECT_DOUBLE_EQ(ratio("s/theta", 6, 2, 0, 0), 3);
  EXPECT_DOUBLE_EQ(ratio("s/theta", 6e-17, 2e-17, 1, 7), 3) << "slow, but all in proportion";
  EXPECT_DOUBLE_EQ(ratio("s/theta", 0, 0, 8, 2), 4) << "the limit";
  EXPECT_DOUBLE_EQ(ratio("s/theta", 2e-44, 0, 8, 2), 4) << "the same, but for rounding";
  EXPECT_TRUE(std::isnan(ratio("s/theta", 0, 0, 0, 0))) << "rest";
  // At a dead point of s, which the crank passes: s is 0 but for rounding.
  const double min_rate = 1e-10 * magnitude;
  EXPECT_TRUE(std::isnan(ratio("theta/s", 0.5 * min_rate, 1, 3, 1)));
  EXPECT_GT(ratio("theta/s", 2 * min_rate, 1, 3, 1), 1e8);
  EXPECT_TRUE(std::isnan(ratio("theta/s", 0, 0, 0.5 * min_rate, 1)));
  EXPECT_GT(ratio("theta/s", 0, 0, 2 * min_rate, 1), 1e8);
  EXPECT_EQ(measures.inputs().size(), 2u);
}

/// Two cranks at rest: rounding is all that is left of their rates, but for which these would be 0.
TEST(Measures, RatiosOfDriversThatRestAreThoseOfAccelerations) {
  const auto ratios = [](const std::string& a, const std::string& b,
                         const std::vector<double>& times) {
    const Rows rows(
        scene(R"({"format": "desmo-mechanism", "version": 1, "name": "two cranks",
      "dimension": 2, "units": {"angle": "deg"},
      "points": {"A": [0, 0], "B": [1, 0], "C": [2, 0], "D": [3, 0]},
      "ground": {"points": ["A", "C"]},
      "bodies": {"first": {"points": ["A", "B"]}, "second": {"points": ["C", "D"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "first"], "points": ["A"]},
                 {"type": "revolute", "bodies": ["ground", "second"], "points": ["C"]}],
      "coordinates": {"a": {"angle": ["A", "B"]}, "b": {"angle": ["C", "D"]}},
      "drivers": ["a", "b"]})",
              "\"a\": {" + a + "}, \"b\": {" + b + "}", R"({"ratios": {"i": ["a", "b"]}})"),
        times);
    std::vector<double> found;
    for (std::size_t k = 0; k < times.size(); ++k) found.push_back(rows(k, "i", Level::velocity));
    return found;
  };
  const auto table = [](const std::string& times, const std::string& values) {
    return R"("type": "table", "ends": "clamped", "times": )" + times + R"(, "values": )" + values;
  };
  // Splines by hand: second derivatives at the ends, from those at the inner knot.
  const std::vector<double> clamped =
      ratios(table("[0, 1, 2]", "[0, 30, 10]"), table("[0, 0.7, 2]", "[0, 7, -10]"), {0, 2});
  EXPECT_NEAR(clamped[0], 165 / 77.47252747252747, 1e-12);
  EXPECT_NEAR(clamped[1], 135 / 64.79289940828403, 1e-12);

  const auto waves = [](const std::string& terms) {
    return R"("type": "harmonic", "mean": 5, "terms": [)" + terms + "]";
  };
  const std::vector<double> rests{0.25, 0.75, 3 * 0.25 + 8, 1.25, 1e6 + 0.25};
  for (const double i : ratios(waves(R"({"amplitude": 30, "frequency": 1})"),
                               waves(R"({"amplitude": 10, "frequency": 3})"), rests))
    EXPECT_NEAR(i, -1 / 3., 1e-12);
  for (const double i :
       ratios(waves(R"({"amplitude": 30, "frequency": 1, "phase": 90})"),
              waves(R"({"amplitude": 10, "frequency": 2, "phase": 90})"), {0, 1, 2, 17}))
    EXPECT_NEAR(i, 0.75, 1e-12);
  // 0.1 is rounded, and so are its multiples.
  for (const double i : ratios(waves(R"({"amplitude": 30, "frequency": 2.5})"),
                               waves(R"({"amplitude": 10, "frequency": 7.5})"), {0.1, 3 * 0.1}))
    EXPECT_NEAR(i, -1 / 3., 1e-12);
  // Accelerations vanish, too: cos wt = cos 2wt = 1.
  const std::string still =
      R"({"amplitude": 2, "frequency": 1}, {"amplitude": -1, "frequency": 2})";
  for (const double i : ratios(waves(still), waves(still), {0, 1, 5}))
    EXPECT_TRUE(std::isnan(i)) << i;
}

/// Numbers of rows are exact, however small.
TEST(Measures, RatiosOfRowsAreThoseOfTheirNumbers) {
  const Scene s = scene(slider_crank, R"("theta": {"type": "constant", "value": 0})",
                        R"({"ratios": {"r": ["s", "theta"]}}, {"distances": ["s"]})");
  const Model m = make_model(s);
  const auto theta = static_cast<std::size_t>(m.coordinate("theta")),
             out = static_cast<std::size_t>(m.coordinate("s"));
  std::vector<double> qd(m.estimate.size()), qdd(qd);
  qd[theta] = 2e-30, qd[out] = 6e-30, qdd[theta] = 1, qdd[out] = 7;
  Measures of_rows(s, m, Measures::DrivenBy::rows), of_motions(s, m);
  EXPECT_DOUBLE_EQ(of_rows.extend({0, 0, m.estimate, qd, qdd}).qd[qd.size()], 3);
  EXPECT_TRUE(std::isnan(of_motions.extend({0, 0, m.estimate, qd, qdd}).qd[qd.size()]));
}

}  // namespace
}  // namespace desmo::measures_test
