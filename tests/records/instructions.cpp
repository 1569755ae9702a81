// Instructions a step: what is counted, and the record.

#include <set>
#include <string>
#include <vector>

#include "bench/experiments/instructions/step_counts.h"
#include "bench/kit/checked_run.h"
#include "formulations/id.h"
#include "tests/started.h"

namespace desmo::instructions::instructions_test {
namespace {

TEST(Counts, AreOfThePapersAnalysesAndOfWhatGoesBeyond) {
  const std::vector<StepCount> all = to_be_counted(0);
  std::set<std::string> names;
  for (const StepCount& count : all) {
    EXPECT_EQ(count.coordinates, 558);
    EXPECT_TRUE(names.insert(count.text()).second) << count.text();
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

using InstructionsRecord = InFolder;

// A record of the program is one that the report reads.
TEST_F(InstructionsRecord, IsReadByTheReport) {
  if (shell("valgrind --version") != 0) GTEST_SKIP() << "needs valgrind";
  const std::string record = file("record.json");
  ASSERT_EQ(shell(DESMO_BENCH " instructions --quick --record " + record +
                  " --filter 'truck.*/(global_automatic_klu|group_symbolic_explicit("
                  "/(lanes|segments):4|/check:proof)?)$'"),
            0);
  const auto is_reported = [&](const std::string& line) {
    return shell(DESMO_REPORT " tables --all " + record + " | grep -Eq '" + line + "'") == 0;
  };
  EXPECT_TRUE(is_reported(" global_automatic_klu *TS-G_klu *[1-9][0-9]{5} *1.00 reference"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit *[1-9][0-9]{3,4} *[1-9][0-9.]* *50"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit/segments:4 *[1-9][0-9]{3} *[1-9][0-9.]* *200"));
  EXPECT_TRUE(is_reported(" group_symbolic_explicit/check:proof *[1-9][0-9]{5} *[0-9.]* *200"));
  EXPECT_EQ(shell(DESMO_BENCH " instructions --coordinates 113"), 64);
}

}  // namespace
}  // namespace desmo::instructions::instructions_test
