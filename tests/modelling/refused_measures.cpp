// Requests of measures that there are not.

#include <gtest/gtest.h>

#include <string>

#include "cases/library/library.h"
#include "tests/contains.h"
#include "tests/modelling/measures.h"
#include "tests/refusal.h"
#include "tests/replaced.h"

namespace desmo::measures_test {
namespace {

/// A pattern asks for all that there are, and for at least one.
TEST(Measures, OfAPatternLeaveOutWhatHasNoTurn) {
  const auto names = [](const std::string& mechanism, const std::string& motion,
                        const std::string& request) {
    const Scene s = scene(mechanism, motion, request);
    const Measures measures(s, make_model(s));
    std::string all;
    for (const Measure& measure : measures.list()) all += measure.names[Level::position] + " ";
    return all;
  };
  const auto of_wishbone = [&](const std::string& request) {
    return names(R"({"library": "double_wishbone"})", "", request);
  };
  EXPECT_EQ(of_wishbone(R"({"rotations": ["upper", "*e*r*"]})"),
            "upper.rotation.x upper.rotation.y upper.rotation.z "
            "lower.rotation.x lower.rotation.y lower.rotation.z ");
  EXPECT_CONTAINS(desmo::refusal([&] { of_wishbone(R"({"rotations": ["u*", "tie_rod"]})"); }),
                  "of body 'tie_rod' do not tell how it is turned");
  for (const char* request :
       {R"({"rotations": ["upper", "tie*"]})", R"({"rotations": ["*", "tie*"]})",
        R"({"rotations": ["tie*"]}, {"joints": ["*"]})"})
    EXPECT_CONTAINS(desmo::refusal([&] { of_wishbone(request); }),
                    "request: the pattern 'tie*' gives nothing: the points and vectors");
  // A body of one point turns about it, nobody knows how far.
  const std::string crank(find_library("slider_crank")->mechanism),
      bob = replaced(replaced(crank, R"("slider": {)", R"("bob": {"points": ["B"]}, "slider": {)"),
                     R"("joints": [)",
                     R"("joints": [{"type": "revolute", "bodies": ["crank", "bob"],
                                    "points": ["B"]},)");
  EXPECT_EQ(names(bob, turning, R"({"joints": ["*"]})"),
            names(crank, turning, R"({"joints": ["*"]})"));
}

TEST(Measures, ThatThereAreNotAreRefused) {
  const auto refusal = [](const std::string& mechanism, const std::string& motion,
                          const std::string& request) {
    const Scene s = scene(mechanism, motion, request);
    return desmo::refusal([&] { outputs_of(s, make_model(s)); });
  };
  EXPECT_CONTAINS(refusal(R"({"library": "double_wishbone"})", "", R"({"rotations": ["tie_rod"]})"),
                  "the points and vectors of body 'tie_rod' do not tell how it is turned");
  EXPECT_CONTAINS(refusal(slider_crank, turning, R"({"ratios": {"r": ["theta", "A.x"]}})"),
                  "'A.x' is fixed");
  EXPECT_CONTAINS(refusal(slider_crank, turning, R"({"ratios": {"C.x": ["s", "theta"]}})"),
                  "the name 'C.x' is taken by a coordinate");
  EXPECT_CONTAINS(refusal(slider_crank, turning,
                          R"({"rotations": ["crank"], "level": "velocity"},
                             {"ratios": {"crank.omega": ["s", "theta"]}})"),
                  "or by another rotation, joint or ratio; rename one");
  EXPECT_EQ(refusal(slider_crank, turning, R"({"rotations": ["slider"]})"), "accepted");
}

}  // namespace
}  // namespace desmo::measures_test
