// Instructions a step: what is counted, and the record.

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <vector>

#include "bench/experiments/instructions/step_counts.h"
#include "bench/kit/checked_run.h"
#include "formulations/id.h"

namespace desmo::instructions::instructions_test {
namespace {

bool can_count() { return std::system("valgrind --version >/dev/null 2>&1") == 0; }

TEST(Counts, AreOfThePapersAnalysesAndOfWhatGoesBeyond) {
  const std::vector<StepCount> all = to_be_counted(0);
  std::set<std::string> names;
  for (const StepCount& count : all) {
    EXPECT_EQ(count.coordinates, 558);
    EXPECT_TRUE(names.insert(count.name()).second) << count.name();
    EXPECT_NO_THROW(parse_id(bench::formulation_of(count.id))) << count.id;
  }
  for (const char* name : {"truck_suspension", "four_bar"})
    for (const char* id :
         {"global_automatic_klu", "group_automatic_klu", "group_automatic_lapack",
          "group_symbolic_klu", "group_symbolic_lapack", "group_symbolic_inlined",
          "group_symbolic_explicit", "group_symbolic_explicit/lanes:4",
          "group_symbolic_explicit/segments:4", "group_symbolic_explicit/check:proof"})
      EXPECT_TRUE(names.contains(std::string(name) + "/558/" + id)) << name << id;
  EXPECT_EQ(to_be_counted(114).front().coordinates, 114);
}

// A record of the program is one that the report reads.
TEST(InstructionsRecord, IsReadByTheReport) {
  if (!can_count()) GTEST_SKIP() << "needs valgrind";
  const std::string record = testing::TempDir() + "desmo_instructions_record.json",
                    run = DESMO_BENCH " instructions --quick --record " + record,
                    quiet = " >/dev/null 2>&1";
  const std::string filter =
      " --filter "
      "'truck.*/(global_automatic_klu|group_symbolic_explicit(/(lanes|segments):4|/"
      "check:proof)?)$'";
  ASSERT_EQ(std::system((run + filter + quiet).c_str()), 0);
  const auto is_reported = [&](const std::string& line) {
    return std::system(
               (DESMO_REPORT " tables --all " + record + " | grep -Eq '" + line + "'").c_str()) ==
           0;
  };
  EXPECT_TRUE(is_reported(" global_automatic_klu *TS-G_klu *[1-9][0-9]{5} *1.00 reference"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit *[1-9][0-9]{3,4} *[1-9][0-9.]* *50"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit/segments:4 *[1-9][0-9]{3} *[1-9][0-9.]* *200"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit/check:proof *[1-9][0-9]{5} *[0-9.]* *200"));
  EXPECT_EQ(
      WEXITSTATUS(std::system((DESMO_BENCH " instructions --coordinates 113" + quiet).c_str())),
      64);
  std::remove(record.c_str());
}

}  // namespace
}  // namespace desmo::instructions::instructions_test
