// The judge finds what is planted; its answers agree with closed forms and other references.
#include "tests/properties/judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/reference/reference.h"
#include "tests/properties/assembled_drawing.h"
#include "tests/properties/formulations.h"
#include "tests/properties/mechanisms.h"
#include "tests/properties/scene_kinds.h"
#include "tests/refusal.h"

namespace desmo::properties::judge_test {
namespace {

/// The Scott–Russell mechanism: C = 2.5 sin θ on the y axis, θ = 0.5 s − t.
const char* const scott_russell_scene = R"({
 "format": "desmo-scene", "version": 2, "name": "Scott-Russell",
 "mechanism": {"format": "desmo-mechanism", "version": 1, "name": "scott_russell", "dimension": 2,
  "units": {"length": "1"},
  "points": {"O": [0, 0], "M": [0.75, 1], "C": [0, 2]}, "vectors": {"y": [0, 1]},
  "ground": {"points": ["O"], "vectors": ["y"]},
  "bodies": {"crank": {"points": ["O", "M"], "length": 1.25}, "bar": {"points": ["M", "C"], "length": 1.25}},
  "joints": [
   {"type": "revolute", "bodies": ["ground", "crank"], "points": ["O"]},
   {"type": "revolute", "bodies": ["crank", "bar"], "points": ["M"]},
   {"type": "revolute_on_slider", "bodies": ["ground", "bar"], "vectors": ["y"], "points": ["O", "C"]}],
  "coordinates": {"theta": {"angle": ["O", "M"]}}, "drivers": ["theta"]},
 "motion": {"theta": {"type": "polynomial", "coefficients": [0.5, -1]}},
 "time": {"start": -0.5, "end": 1.5, "step": 0.125}})";

const DrawnScene& scott_russell_through_its_change_point() {
  static const DrawnScene scene = [] {
    DrawnScene s;
    s.text = scott_russell_scene;
    read_drawn_scene(s);
    return s;
  }();
  return scene;
}

/// Returns an answer as a row, rounded to double, with radii of two units in the last place.
CheckedRow row_of(int index, const ReferenceInstant& answer) {
  CheckedRow row{.index = index, .values = {answer.q, answer.qd, answer.qdd}};
  for (const Level level : all_levels)
    for (const double x : row.values[level]) row.radius[level].push_back(std::abs(x) * 0x1p-52);
  return row;
}

/// Returns the answers as a run.
CheckedRows answers_as_run(const DrawnScene& s) {
  CheckedRows run;
  for (const TrueInstant& t : s.truth.instants)
    if (has_answer(t))
      run.rows.push_back(row_of(static_cast<int>(&t - s.truth.instants.data()), t.instant));
  return run;
}

std::string verdict(const DrawnScene& s, const CheckedRows& run) {
  const Judgement j = judge(s, run);
  return j.wrong ? j.wrong->what : "";
}

TEST(Judge, AnswersGoSmoothlyThroughAChangePoint) {
  const DrawnScene& s = scott_russell_through_its_change_point();
  const int c = s.plan.model.coordinate("C.y");
  int answers = 0;
  for (const TrueInstant& t : s.truth.instants) {
    const double theta = 0.5 - t.instant.time;
    if (!has_answer(t)) {
      EXPECT_EQ(theta, 0);
      continue;
    }
    ++answers;
    EXPECT_NEAR(t.instant.q[c], 2.5 * std::sin(theta), 1e-15);
    EXPECT_NEAR(t.instant.qd[c], -2.5 * std::cos(theta), 1e-15);
    EXPECT_NEAR(t.instant.qdd[c], -2.5 * std::sin(theta), 1e-15);
  }
  EXPECT_EQ(answers, 16);
  EXPECT_EQ(s.truth.instants[9].path_condition, INFINITY);
  EXPECT_TRUE(s.truth.regular[7]);
  EXPECT_FALSE(s.truth.regular[9]);
}

TEST(Judge, AnswersAgreeWithTheReferenceAwayFromSingularPositions) {
  const int kinds = static_cast<int>(scene_kinds().size());  // all of the first kind are random
  int compared = 0;
  for (int number = 0; number < 20 * kinds && compared < 3; number += kinds) {
    const DrawnScene s = draw_scene(7, number);
    const Model& m = s.plan.model;
    std::vector<double> times;
    double condition = 1;
    for (const TrueInstant& t : s.truth.instants) {
      times.push_back(t.instant.time);
      condition = std::max(condition, t.path_condition);
    }
    const int driver = m.entities[m.drivers[0].coordinate].first;
    const double start = s.truth.instants[0].instant.q[driver];
    if (condition > 1e4 || std::abs(start - m.estimate[driver]) > 1e-9) continue;
    const std::vector<ReferenceInstant> reference =
        reference_solution(m, times, Precision::quadruple);
    CheckedRows run;
    for (std::size_t i = 0; i < times.size(); ++i)
      run.rows.push_back(row_of(static_cast<int>(i), reference[i]));
    EXPECT_EQ(verdict(s, run), "") << number;
    ++compared;
  }
  EXPECT_GE(compared, 2);
}

TEST(Judge, FindsWhatIsPlanted) {
  const DrawnScene& s = scott_russell_through_its_change_point();
  const int c = s.plan.model.coordinate("C.y");
  const CheckedRows right = answers_as_run(s);
  EXPECT_EQ(verdict(s, right), "");

  for (const Level level : all_levels) {
    CheckedRows wrong = right;
    wrong.rows[12].values[level][c] *= 1 + 0x1p-50;
    EXPECT_EQ(verdict(s, wrong), "outside its radius");
    EXPECT_EQ(judge(s, wrong).wrong->coordinate, "C.y");
    EXPECT_EQ(judge(s, wrong).wrong->level, level);
    CheckedRows unknown = right;
    unknown.rows[12].radius[level][c] = INFINITY;
    EXPECT_EQ(verdict(s, unknown), "without a radius");
  }

  CheckedRows other_branch = right;  // after the change point, where C may rest
  other_branch.rows[12].values.position[c] = 0;
  EXPECT_EQ(verdict(s, other_branch), "outside its radius");
  other_branch.rows[12].flag = {.kind = RowFlag::Kind::crossing};
  EXPECT_EQ(verdict(s, other_branch), "outside its radius");
  other_branch.rows[12].flag = {.kind = RowFlag::Kind::branch};
  EXPECT_EQ(verdict(s, other_branch), "");
  other_branch.rows[12].values.position[c] = NAN;
  EXPECT_EQ(verdict(s, other_branch), "not finite");

  CheckedRows silent = right;  // at the change point itself
  silent.rows.insert(silent.rows.begin() + 8, right.rows[7]);
  silent.rows[8].index = 8;
  EXPECT_EQ(verdict(s, silent), "no answer");
  silent.rows[8].flag = {.kind = RowFlag::Kind::on_point};
  EXPECT_EQ(verdict(s, silent), "");
}

TEST(Judge, CountsRegularInstantsThatAreFlaggedOrMissing) {
  const DrawnScene& s = scott_russell_through_its_change_point();
  CheckedRows run = answers_as_run(s);
  EXPECT_EQ(judge(s, run).rows, 17);
  EXPECT_TRUE(judge(s, run).regular_flags.empty());
  run.rows[2].flag = {.kind = RowFlag::Kind::unproven};
  run.rows[12].flag = {.kind = RowFlag::Kind::unproven};  // beyond the change point
  run.rows.erase(run.rows.begin() + 4);
  const Judgement j = judge(s, run);
  EXPECT_EQ(j.regular_flags.at("unproven"), 1);
  EXPECT_EQ(j.flags.at("unproven"), 2);
  EXPECT_EQ(j.regular_flags.at("missing"), 1);
}

/// Returns the first scene of a kind and an aim.
DrawnScene find_scene(const std::string& kind, const std::string& aim, double least_misfit) {
  for (int number = 0; number < 400; ++number) {
    if (kind != scene_kinds()[number % scene_kinds().size()].name) continue;
    DrawnScene s = draw_scene(3, number);
    if (s.aim != aim) continue;
    for (const TrueInstant& t : s.truth.instants)
      if (has_answer(t) && largest_misfit(s.plan.model, t.instant.q) >= least_misfit) return s;
  }
  throw std::runtime_error("no scene of " + kind);
}

TEST(Judge, FindsContradictionsWithoutAFlag) {
  const DrawnScene s = find_scene("contradicting", "contradicting", 1e-10);
  CheckedRows run = answers_as_run(s);
  EXPECT_EQ(verdict(s, run), "a contradiction");
  for (CheckedRow& row : run.rows) row.flag = {.kind = RowFlag::Kind::misfit};
  EXPECT_NE(verdict(s, run), "a contradiction");
}

/// The bar that folds onto the crank stays there, exactly. That is the smooth continuation of
/// nothing before it, though flagged; but where no answer is decided, any branch is right.
TEST(Judge, TakesAnotherBranchOnlyWhereRoundingsDecide) {
  DrawnScene s = scott_russell_through_its_change_point();
  const Model& m = s.plan.model;
  CheckedRows run = answers_as_run(s);
  for (CheckedRow& row : run.rows) {
    if (row.index <= 8) continue;
    for (const Level level : all_levels) {
      for (const char* name : {"C.x", "C.y"}) row.values[level][m.coordinate(name)] = 0;
      std::ranges::fill(row.radius[level], 1e-15);
    }
  }
  EXPECT_EQ(verdict(s, run), "outside its radius");
  for (CheckedRow& row : run.rows)
    if (row.index == 9) row.flag = {.kind = RowFlag::Kind::crossing};
  EXPECT_EQ(verdict(s, run), "outside its radius");
  for (int i = 9; i < std::ssize(s.truth.decided); ++i) s.truth.decided[i] = false;
  EXPECT_EQ(verdict(s, run), "");
  run.rows.back().values.velocity[m.coordinate("C.y")] = 1e-14;
  EXPECT_EQ(verdict(s, run), "outside its radius");
}

TEST(Judge, AssemblesARoughDrawing) {
  const DrawnScene s = find_scene("rough", "rough drawing", 0);
  const Model m = with_assembled_drawing(s.plan.model);
  const Model again = with_assembled_drawing(m);
  for (int i = 0; i < m.coordinates(); ++i)
    EXPECT_NEAR(m.estimate[i], again.estimate[i], 1e-15 * (1 + std::abs(m.estimate[i])));
}

TEST(Draw, ScenesAreDrawnAgainFromTheirNumber) {
  const std::string text = draw_scene(3, 4).text;
  EXPECT_EQ(draw_scene(3, 4).text, text);
  EXPECT_NE(draw_scene(4, 4).text, text);
}

TEST(Draw, EveryFamilyCanBeModelled) {
  Random random(5);
  std::vector<Family> all = families();
  const auto overconstrained = overconstrained_families();
  all.insert(all.end(), overconstrained.begin(), overconstrained.end());
  for (const Family& family : all) {
    int modelled = 0;
    for (int i = 0; i < 10 && modelled == 0; ++i) {
      const Drawn d = draw(family, random);  // dimensions may not close
      const std::vector<Motion> still(d.direction.size(), Polynomial{});
      modelled += refusal([&] { model_mechanism(d.mechanism, still); }) == "accepted";
    }
    EXPECT_EQ(modelled, 1) << family.name;
  }
}

TEST(Draw, IdsAreAHundred) {
  std::vector<std::string> ids = drawn_ids();
  for (const std::string& id : ids) EXPECT_NO_THROW(parse_id(id)) << id;
  EXPECT_GE(ids.size(), 100u);
  std::ranges::sort(ids);
  EXPECT_EQ(std::ranges::adjacent_find(ids), ids.end());
}

}  // namespace
}  // namespace desmo::properties::judge_test
