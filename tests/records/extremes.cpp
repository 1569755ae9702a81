// desmo_bench extremes: its exit codes, and a record that desmo_report reads.

#include <nlohmann/json.hpp>
#include <set>

#include "tests/started.h"

namespace desmo::extremes_program_test {
namespace {

class ExtremesProgram : public InFolder {
 protected:
  int extremes(const std::string& arguments) const {
    return run(DESMO_BENCH " extremes --quick --record " + record_ + " " + arguments).code;
  }
  const std::string record_ = file("record.json");
};

/// Nothing is found wrong next to dead points either, which are in row 3.
TEST_F(ExtremesProgram, RecordsWhatTheReportReads) {
  for (const char* rows : {"--row 10 --row 13 --filter '^group_.*_eigen$'",
                           "--row 3 --filter '^global_automatic_klu$'"}) {
    EXPECT_EQ(extremes(rows), 0) << rows;
    EXPECT_EQ(run(DESMO_REPORT " tables " + record_).code, 0) << rows;
  }
}

TEST_F(ExtremesProgram, TriesOneFormulationOfEachKindInAQuickRun) {
  ASSERT_EQ(extremes("--row 12"), 0);
  const nlohmann::json record = nlohmann::json::parse(text_of(record_));
  std::set<std::string> ids;
  for (const auto& result : record["extremes"]["results"]) {
    const std::string id = result["id"];
    ids.insert(id.substr(0, id.find('/')));  // without the tolerance of the case
  }
  EXPECT_EQ(ids, (std::set<std::string>{"global_automatic_klu", "group_symbolic_inlined",
                                        "block_symbolic_inlined", "group_symbolic_explicit"}));
}

TEST_F(ExtremesProgram, ComplainsOfMistakes) {
  EXPECT_EQ(extremes("--row 99"), 64);
  EXPECT_EQ(extremes("--row 3 --case 'no such case'"), 64);
  EXPECT_EQ(extremes("--row 3 --luck"), 64);
  EXPECT_FALSE(std::filesystem::exists(record_));
}

}  // namespace
}  // namespace desmo::extremes_program_test
