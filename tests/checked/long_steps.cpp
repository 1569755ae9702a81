// Motions in long steps, or near singular positions, are followed on the branch of the drawing.

#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <numbers>
#include <ostream>
#include <string>
#include <vector>

#include "formulations/verification/reference/reference.h"
#include "tests/checked/motions.h"
#include "tests/dead_point.h"

namespace desmo::long_steps_test {
namespace {

using std::numbers::pi;

struct Steps {
  const char* name;
  std::function<Model()> model;
  TimeGrid grid;
  std::vector<const char*> ids = {"global_automatic_klu", "group_symbolic_explicit"};
};

void PrintTo(const Steps& steps, std::ostream* out) { *out << steps.name; }

Model of_file(const char* name) { return make_model(scene_file(name)); }
Model of_library(const char* name) { return make_model(library_scene(name)); }
const HarmonicSum rocking{pi - 0.501, {{0.5, pi, pi / 2}}};

const Steps all_steps[] = {
    {"third of a radian", [] { return four_bar_model(1); }, {0, 0.3, 21}},
    {"radian", [] { return four_bar_model(1); }, {0, 1, 21}},
    {"spatial, long", [] { return of_library("rssr"); }, {0, 0.125, 25}},
    {"sixth of a turn, whole turns of an angle",
     [] { return of_library("whitworth"); },
     {0, 1. / 6, 19},
     {"group_automatic_klu"}},
    {"half a radian", [] { return of_file("drag_link"); }, {0, 1. / 60, 61}},
    {"from rest as t^5",
     [] {
       return locking_four_bar(Polynomial{{0.5, 0, 0, 0, 0, 1}});
     },
     {0, 0.01, 101}},
    {"through rest",
     [] {
       return locking_four_bar(HarmonicSum{0.5, {{0.5, 2 * pi, -pi / 8}}});
     },
     {5. / 16, 1. / 128, 129}},
    {"turning back near a dead point",
     [] {
       return locking_four_bar(HarmonicSum{dead_point - 1e-6 - 0.5, {{0.5, 2 * pi, 0}}});
     },
     {0, 0.01, 101},
     {"global_automatic_klu/stride:2", "group_symbolic_explicit/stride:16"}},
    {"turning back between two instants",
     [] {
       return locking_four_bar(Polynomial{{dead_point - 0.02 - 0.84, 0.41, -0.05}});
     },
     {0, 1, 9}},
    {"slider near a dead point",
     [] { return driven_slider(1e-4); },
     {0, 0.01, 101},
     {"global_automatic_klu/stride:2", "group_automatic_lapack/stride:7"}},
    {"slider nearer", [] { return driven_slider(1e-10); }, {0, 1. / 37, 38}},
    {"stride of many radians",
     [] { return of_library("andrews"); },
     {0, 0.5 / pi, 33},
     {"global_automatic_klu/stride:16", "block_symbolic_explicit/stride:16"}},
    {"millimetres on 100 m", [] { return make_model(small_dyad(100)); }, {0, 0.1, 11}},
    {"fast arm",
     [] { return make_model(four_bar_on_arm("60 mm on an arm of 20 m, fast")); },
     {0, 0.05, 61}},
    {"rocking next to a change point",
     [] {
       return make_model(parallelogram(rocking, {0, 1, 1}));
     },
     {0, 1. / 128, 513}},
};

class LongSteps : public testing::TestWithParam<Steps> {};

TEST_P(LongSteps, IsFollowed) {
  const Steps& steps = GetParam();
  const Model m = steps.model();
  const Reference reference = make_reference(
      m, times_of(solve_checked(m, steps.grid, steps.ids[0], Level::position).rows, 17));
  for (const char* id : steps.ids)
    for (const Level level : all_levels) {
      if (DESMO_SANITIZED && level < Level::acceleration) continue;
      SCOPED_TRACE(id);
      const CheckedRows r = solve_checked(m, steps.grid, id, level);
      EXPECT_EQ(r.summary.outcome(), Outcome::converged) << describe(r.summary, m);
      EXPECT_EQ(expect_within_radii(m, r.rows, reference.instants), std::ssize(reference.instants));
      EXPECT_LE(r.summary.radius.position, 1e-10);
    }
}

std::string step_name(const testing::TestParamInfo<Steps>& info) {
  std::string name = info.param.name;
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(c); }, '_');
  return name;
}

INSTANTIATE_TEST_SUITE_P(Motions, LongSteps, testing::ValuesIn(all_steps), step_name);

}  // namespace
}  // namespace desmo::long_steps_test
