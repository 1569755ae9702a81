// Time against size: what is measured is right, and the record is one that the report reads.

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/experiments/size/series.h"
#include "bench/kit/formulation_candidate.h"
#include "bench/kit/problem.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "tests/started.h"

namespace desmo::size::size_test {
namespace {

using bench::FormulationCandidate;
using bench::make_problem;
using bench::moving_unknowns;
using bench::Problem;

TimeGrid instants(int count) { return {0, 0.01, count}; }

Problem problem_of(const char* name, int coordinates) {
  return make_problem(make_model(make_scene(find_case(name), coordinates)), instants(5), 1e-12);
}

TEST(SizeCandidate, ThatIsWrongHasNoTime) {
  const Problem problem = problem_of("truck_suspension", 114);
  EXPECT_STREQ(problem.checked_against, "quadruple");
  EXPECT_EQ(problem.reference.instants.size(), 3u);
  // One iteration is not enough; the tolerance is not asked of a fixed number of them.
  FormulationCandidate inexact(problem, "group_symbolic_inlined/iterations:1",
                               {.tolerance = problem.tolerance});
  inexact.verify();
  inexact.sample_afresh(0);
  EXPECT_FALSE(inexact.is_verified());
  EXPECT_CONTAINS(inexact.message(), "differs from the reference");
  EXPECT_FALSE(inexact.is_timed());
  Problem undefined = problem;
  undefined.plan.model.drivers.front().motion = Polynomial{{NAN}};
  FormulationCandidate failing(undefined, "global_automatic_klu",
                               {.tolerance = undefined.tolerance});
  failing.verify();
  EXPECT_CONTAINS(failing.message(), "not finite");
  EXPECT_THROW(FormulationCandidate(problem, "global_automatic_abacus", Settings{}),
               std::invalid_argument);
}

TEST(SizeCandidate, ComparesTheLargestWithDoublePrecision) {
  const Problem problem =
      make_problem(make_model(make_scene(find_case("four_bar"), 12'003)), instants(3), 1e-10);
  EXPECT_STREQ(problem.checked_against, "double");
  FormulationCandidate candidate(problem, "group_symbolic_inlined",
                                 {.tolerance = problem.tolerance});
  candidate.verify();
  EXPECT_TRUE(candidate.is_verified()) << candidate.message();
}

TEST(Cut, HasTheUnknownsAskedForAndCanBeSolved) {
  for (const Case& c : cases()) {
    const Model whole = make_model(make_scene(c, 114));
    int last = 0;
    for (const int least : {10, 40, 60, 100}) {
      const Model cut = smallest_part(whole, least);
      const int found = moving_unknowns(cut);
      EXPECT_GE(found, least) << c.name;
      EXPECT_LT(found, least + 21) << c.name;  // what the first truck entity needs is 21
      EXPECT_GE(found, last) << c.name;
      EXPECT_EQ(moving_unknowns(smallest_part(whole, found)), found) << c.name;
      last = found;
      const Problem problem = make_problem(cut, instants(3), 1e-12);
      for (const char* id : {"global_automatic_eigen", "global_automatic_klu"}) {
        FormulationCandidate candidate(problem, id, {.tolerance = problem.tolerance});
        candidate.verify();
        EXPECT_TRUE(candidate.is_verified())
            << c.name << ' ' << least << ' ' << candidate.message();
      }
    }
    EXPECT_EQ(moving_unknowns(smallest_part(whole, 1'000'000)), moving_unknowns(whole));
  }
}

TEST(SizeSeries, AskBothQuestionsOfBothCases) {
  std::map<std::string, std::pair<int, int>> ranges;
  for (const SizeSeries& series : make_series()) {
    const std::string name =
        std::string(name_of(series.question)) + "/" + std::string(series.definition->name);
    const auto [place, is_new] = ranges.emplace(name, std::pair(series.size, series.size));
    EXPECT_TRUE(is_new || series.size > place->second.second) << name;  // ascending, each once
    place->second.second = series.size;
    for (const std::string_view id : series.ids) EXPECT_NO_THROW(parse_id(id)) << id;
    if (series.question == Question::growth) {
      EXPECT_NO_THROW(make_scene(*series.definition, series.size));
    }
  }
  ASSERT_EQ(ranges.size(), 4u);
  for (const Case& c : cases()) {
    const auto [least, most] = ranges.at("growth/" + std::string(c.name));
    EXPECT_EQ(least, c.sizes.front());
    EXPECT_GT(most, 99'000);
    EXPECT_LE(ranges.at("break_even/" + std::string(c.name)).first, 21);
    EXPECT_GE(ranges.at("break_even/" + std::string(c.name)).second, 500);
  }
}

using SizeRecord = InFolder;

// A record of the program is one that the report reads, and has what the filter lets through. How
// many sizes a slope has is looked for by itself: behind a wide interval it stands on the next
// line.
TEST_F(SizeRecord, IsReadByTheReport) {
  const std::string record = file("record.json");
  ASSERT_EQ(shell(DESMO_BENCH " size --quick --repetitions 2 --record " + record +
                  " --filter '(four_bar/(114|225|336)/group_symbolic_explicit|break_even/four_bar/"
                  "[1-3].*/global_automatic_(klu|lapack))$'"),
            0);
  for (const std::string found :
       {" four_bar *group_symbolic_explicit ", " n=3( |$)", " four_bar *klu "})
    EXPECT_EQ(shell(DESMO_REPORT " tables --all " + record + " | grep -Eq '" + found + "'"), 0)
        << found;
}

}  // namespace
}  // namespace desmo::size::size_test
