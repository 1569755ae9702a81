// Couplings that modelling left out, far from the drawing: those that hold but for the last digits
// of their factors and tables are not flagged, others are.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/groupwise/double_solution.h"
#include "formulations/verification/branch/left_out_equations.h"
#include "formulations/verification/certificate/refinement.h"
#include "tests/certificate/containment.h"
#include "tests/wheel.h"

namespace desmo::left_out_couplings_test {
namespace {

/// Returns the largest misfit at times up to 1 s; 0: no instant is flagged.
double misfit_of(const std::string& scene) {
  const Model m = make_model(parse_scene(scene, "couplings.json", ""));
  LeftOutEquations left_out(m);
  EXPECT_TRUE(left_out.any());
  Refinement refinement(m);
  double largest = 0;
  for (const ReferenceInstant& s : double_solution(m, std::vector{0., 0.25, 0.5, 0.75, 1.})) {
    const RefinedInstant& r = refinement.refine(instant_of(s));
    EXPECT_TRUE(r.proven);
    if (const auto misfit = left_out.check(r)) largest = std::max(largest, misfit->amount);
  }
  return largest;
}

/// Returns a coupling of coordinates of `names`.
std::string sum(const char* names, double first, double second) {
  return formatted(R"("%s": {"sum": {"%c": %.17g, "%c": %.17g}})", names, names[0], first, names[1],
                   second);
}

/// Returns three shafts, each coupled to the others. The first turns from 0 at a speed [rad/s].
std::string shafts(const std::array<std::string, 3>& couplings, double speed) {
  return R"({"format": "desmo-scene", "version": 2, "mechanism": {
    "format": "desmo-mechanism", "version": 1, "name": "shafts", "dimension": 2,
    "points": {"O": [0, 0], "A": [1, 0], "P": [3, 0], "B": [3, 1], "Q": [6, 0], "C": [7, 0]},
    "ground": {"points": ["O", "P", "Q"]},
    "bodies": {"1": {"points": ["O", "A"]}, "2": {"points": ["P", "B"]},
               "3": {"points": ["Q", "C"]}},
    "joints": [{"type": "revolute", "bodies": ["ground", "1"], "points": ["O"]},
               {"type": "revolute", "bodies": ["ground", "2"], "points": ["P"]},
               {"type": "revolute", "bodies": ["ground", "3"], "points": ["Q"]}],
    "coordinates": {"a": {"angle": ["O", "A"]}, "b": {"angle": ["P", "B"]},
                    "c": {"angle": ["Q", "C"]}},
    "couplings": {)" +
         couplings[0] + ", " + couplings[1] + ", " + couplings[2] +
         R"(}, "drivers": ["a"]},
  "motion": {"a": {"type": "polynomial", "coefficients": [0, )" +
         formatted("%.17g", speed) + R"(]}}, "time": {"end": 1, "step": 0.25}})";
}

/// Couplings p a = q b, p b = q c and q² c = p² a, in decimals.
TEST(LeftOutCouplings, HoldWhereDecimalFactorsDo) {
  struct Factors {
    double p, q, squared_p, squared_q;
  };
  for (const auto& [p, q, squared_p, squared_q] :
       {Factors{0.1, 0.3, 0.01, 0.09}, Factors{0.3, 0.1, 0.09, 0.01}, Factors{0.7, 0.3, 0.49, 0.09},
        Factors{1.1, 3.3, 1.21, 10.89}, Factors{1.7, 2.3, 2.89, 5.29}})
    for (const double speed : {1., 40., 3e3, -1e6})
      EXPECT_EQ(misfit_of(shafts(
                    {sum("ab", p, -q), sum("bc", p, -q), sum("ca", squared_q, -squared_p)}, speed)),
                0)
          << p << ' ' << q << ' ' << speed;
}

/// Six factors, each varied by 2 u times itself, explain 12 u times the way, u = 2⁻⁵³. Here the
/// last factor alone is off: three units of its last digit are 5 u, fourteen are 25 u.
TEST(LeftOutCouplings, HoldForTheLastDigitsOfTheirFactorsAlone) {
  constexpr double last_digit = 0x1p-49;  // of 9
  for (const double speed : {1e3, 1e6})
    for (const auto& [digits, holds] : {std::pair(3, true), {14, false}, {1000, false}}) {
      const double misfit = misfit_of(shafts(
          {sum("ab", 3, -1), sum("bc", 3, -1), sum("ca", 1, -9 - digits * last_digit)}, speed));
      const double expected = digits * last_digit * speed / 9;  // Φ in units of the largest factor
      EXPECT_NEAR(misfit, holds ? 0 : expected, 0.1 * expected) << digits;
    }
}

/// A table that repeats, and a sum with the same ratio, many turns later.
TEST(LeftOutCouplings, ByTablesHoldAfterManyTurns) {
  const std::vector<double> at{0, 0.1, 0.2, 0.3}, values{0, 0.3, 0.6, 0.9};
  for (const double off : {0., 1e-11})
    for (const double speed : {40., 1e4, -1e5}) {  // [°/s]
      const Wheel wheel{.couplings = coupling_table("table", at, values, "indexing") + ", " +
                                     sum("wa", 0.1, -0.3 * (1 + off)),
                        .speed = speed};
      EXPECT_EQ(misfit_of(wheel.text()) > 0, off > 0) << speed;
    }
}

}  // namespace
}  // namespace desmo::left_out_couplings_test
