// Ids with settings: what is printed reads back, and what makes no sense is refused by name.

#include "formulations/id.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "tests/contains.h"
#include "tests/mechanisms.h"
#include "tests/refusal.h"

namespace desmo::id_test {
namespace {

/// The setting max_iterations has no suffix.
TEST(Id, HasItsSuffixesInOneOrder) {
  const Settings all{.tolerance = 2.5e-7,
                     .max_iterations = 7,
                     .guess = Guess::hermite5,
                     .fixed_iterations = 2,
                     .jacobian = JacobianUpdate::step,
                     .btf = BlockTriangularForm::off};
  const std::string id =
      "global_automatic_klu/guess:hermite5/jacobian:step/btf:off/iterations:2/tolerance:2.5e-7";
  EXPECT_EQ(id_with(find_variant("global_automatic_klu"), all), id);
  const Configuration back = parse_id(
      "global_automatic_klu/tolerance:2.5e-07/iterations:2/btf:off/guess:hermite5/jacobian:step");
  EXPECT_EQ(id_with(*back.variant, back.settings), id);
}

TEST(Id, ReadsBackEveryValueOfEverySuffix) {
  const std::pair<std::string, std::vector<const char*>> ids[] = {
      {"group_automatic_eigen",
       {"", "/guess:linear", "/guess:quadratic", "/guess:hermite3", "/guess:hermite5",
        "/guess:adams8", "/jacobian:step", "/iterations:1", "/iterations:12", "/tolerance:1e-6",
        "/stride:2", "/stride:64", "/stride:8/tolerance:1e-6", "/tolerance:1e-10",
        "/tolerance:3e+0", "/guess:hermite5/jacobian:step/tolerance:1e-8"}},
      {"group_symbolic_explicit",
       {"/lanes:4", "/lanes:8", "/segments:4", "/segments:8", "/segments:4/threads:2"}},
      {"global_automatic_klu", {"/btf:off", "/coordinates:reference"}},
      {"group_automatic_lapack", {"/coordinates:relative/frames:exact"}}};
  for (const auto& [variant, suffixes] : ids)
    for (const char* suffix : suffixes) {
      const Configuration c = parse_id(variant + suffix);
      EXPECT_EQ(c.variant, &find_variant(variant));
      EXPECT_EQ(id_with(*c.variant, c.settings), variant + suffix);
    }
  EXPECT_EQ(
      id_with(find_variant("group_automatic_eigen"),
              parse_id("group_automatic_eigen/guess:previous/stride:1/tolerance:1e-12").settings),
      "group_automatic_eigen");
}

TEST(Id, LeavesTheBaseWhereItSaysNothing) {
  const Settings base{.tolerance = 1e-7, .max_iterations = 40, .guess = Guess::linear};
  const Settings s = parse_id("group_symbolic_klu/jacobian:step/guess:hermite3", base).settings;
  EXPECT_EQ(s.tolerance, 1e-7);
  EXPECT_EQ(s.max_iterations, 40);
  EXPECT_EQ(s.guess, Guess::hermite3);
  EXPECT_EQ(s.jacobian, JacobianUpdate::step);
}

TEST(Id, SaysWhatIsWrong) {
  const std::pair<const char*, const char*> wrong[] = {
      {"group_symbolic_ma57", "unknown formulation 'group_symbolic_ma57'; there are:"},
      {"group_symbolic_ma57/guess:linear", "unknown formulation 'group_symbolic_ma57'"},
      {"", "unknown formulation ''"},
      {"/guess:linear", "unknown formulation ''"},
      {"group_symbolic_klu/", "unknown suffix '/'"},
      {"group_symbolic_klu/guess", "unknown suffix '/guess'"},
      {"group_symbolic_klu/gess:linear",
       "unknown suffix '/gess:linear'; there are, each followed by ':' and a value: coordinates, "
       "frames, guess, jacobian, btf, lanes, segments, threads, stride, iterations, tolerance"},
      {"group_symbolic_explicit/lanes:5", "unknown value '5' of '/lanes:'; there are: 4, 8"},
      {"group_symbolic_klu/guess:cubic",
       "unknown value 'cubic' of '/guess:'; there are: previous, linear, quadratic, hermite3, "
       "hermite5, adams8"},
      {"group_symbolic_klu/guess:", "unknown value '' of '/guess:'"},
      {"group_symbolic_klu/guess:linear/guess:linear", "'/guess:' is given twice"},
      {"group_symbolic_klu/iterations:0", "unknown value '0' of '/iterations:'"},
      {"group_symbolic_klu/iterations:2.5", "a whole number from 1 to 1000"},
      {"group_symbolic_klu/threads:0", "unknown value '0' of '/threads:'"},
      {"group_symbolic_klu/threads:65", "a whole number from 1 to 64"},
      {"group_symbolic_inlined/segments:4", "four lanes or eight, in explicit order"},
      {"group_symbolic_inlined/lanes:4", "four lanes or eight, in explicit order"},
      {"group_symbolic_explicit/lanes:4/segments:4", "not both"},
      {"group_symbolic_klu/stride:0", "unknown value '0' of '/stride:'"},
      {"group_symbolic_klu/stride:65", "a whole number from 1 to 64"},
      {"group_symbolic_klu/tolerance:-1", "a number above 0"},
      {"group_symbolic_klu/tolerance:1e999", "a number above 0"},
      {"group_symbolic_klu/tolerance:nan", "a number above 0"},
      {"group_symbolic_klu/tolerance:1e-6x", "a number above 0"},
      {"global_automatic_umfpack/btf:off", "block triangular form is KLU's"},
      {"group_symbolic_inlined/btf:off", "block triangular form is KLU's"},
      {"group_automatic_klu/frames:exact", "in reference and relative coordinates alone"},
      {"group_automatic_klu/frames:exact/coordinates:basis",
       "in reference and relative coordinates alone"},
      {"group_symbolic_klu/coordinates:relative/frames:exact", "evaluated all at once"},
      {"group_symbolic_inlined/coordinates:relative/frames:exact", "evaluated all at once"},
      {"group_symbolic_explicit/coordinates:reference/frames:exact", "evaluated all at once"},
      {"group_mixed", "unknown formulation 'group_mixed'"},
      {"group\x1b[2J", "unknown formulation 'group\\u001b[2J'"},
      {"group_symbolic_klu/\x1b[2J", "unknown suffix '/\\u001b[2J'"},
      {"group_symbolic_inlined/jacobian:step", "keeps no factors"},
  };
  for (const auto& [id, message] : wrong)
    EXPECT_CONTAINS(refusal([&] { parse_id(id); }), message) << id;
}

TEST(Settings, ThatAreNotOfferedOrCannotEndAreRefused) {
  const Model m = four_bar_model(1);
  for (const Settings& wrong : {Settings{.stride = 65},
                                {.threads = 0},
                                {.lanes = 4},
                                {.jacobian = JacobianUpdate::step},
                                {.tolerance = 0},
                                {.tolerance = NAN},
                                {.max_iterations = 0},
                                {.fixed_iterations = -1},
                                {.fixed_iterations = 1001}})
    EXPECT_THROW(make_formulation(find_variant("group_symbolic_inlined"), m, wrong),
                 std::invalid_argument);
}

}  // namespace
}  // namespace desmo::id_test
