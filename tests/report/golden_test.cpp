// A record of the schema that is read, with every section, gives the report that it gave. When the
// report is changed on purpose, DESMO_UPDATE_GOLDEN=1 writes it anew; the change is then to be
// reviewed like any other.

#include <cstdlib>
#include <fstream>

#include "cases/io/text_file.h"
#include "report/formats/formats.h"
#include "tests/report/sample.h"

namespace desmo::report::golden_test {
namespace {

/// The paper's experiment, and all others.
constexpr const char *paper = "golden/2.0.0", *others = "golden/2.1.0-others";

class Golden : public ::testing::TestWithParam<const char*> {};

TEST_P(Golden, GivesTheReportItGave) {
  const std::string name = GetParam();
  const std::string report = to_markdown(make_report(read_record(data_file(name + ".json"))));
  if (std::getenv("DESMO_UPDATE_GOLDEN")) std::ofstream(data_file(name + ".md")) << report;
  EXPECT_EQ(report, read_text(data_file(name + ".md")));
}

INSTANTIATE_TEST_SUITE_P(Records, Golden, ::testing::Values(paper, others),
                         [](const auto& name) { return name.param == paper ? "Paper" : "Others"; });

TEST(GoldenRecords, HaveEverySection) {
  const Record record = read_record(data_file(std::string(paper) + ".json"));
  for (const bool is_empty :
       {record.candidates.empty(), record.requests.empty(), record.profiles.empty(),
        record.candidates.begin()->second.time.windows.samples.empty()})
    EXPECT_FALSE(is_empty);
  const Record other = read_record(data_file(std::string(others) + ".json"));
  for (const bool is_empty :
       {other.floors.empty(), other.points.empty(), other.growth.empty(), other.break_even.empty(),
        other.instructions.empty(), other.modelled.empty(), other.extreme_rows.empty(),
        other.extremes.empty()})
    EXPECT_FALSE(is_empty);
  EXPECT_FALSE(has_paper(other));
}

}  // namespace
}  // namespace desmo::report::golden_test
