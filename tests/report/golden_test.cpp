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

}  // namespace
}  // namespace desmo::report::golden_test
