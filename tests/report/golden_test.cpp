// Records of every minor version there was are read forever, and give the report that they gave.
// When the report itself is changed on purpose, DESMO_UPDATE_GOLDEN=1 writes it anew; the change is
// then to be reviewed like any other.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <fstream>
#include <string_view>

#include "report/formats/formats.h"
#include "report/record_reader.h"
#include "report/report.h"
#include "report/time_words.h"
#include "tests/report/sample.h"

namespace desmo::report::golden_test {
namespace {

constexpr std::array minors{"1.0.0", "1.1.0", "1.2.0", "1.3.0", "1.4.0", "1.5.0", "1.6.0"};
// Of desmo_bench each, and of the other programs since there are any.
constexpr std::array records{"1.0.0", "1.1.0",          "1.2.0",           "1.3.0",
                             "1.4.0", "1.5.0",          "1.5.0-precision", "1.5.0-promises",
                             "1.6.0", "1.7.0-extremes", "1.7.0-growth",    "1.7.0-instructions",
                             "1.10.0"};

class Golden : public ::testing::TestWithParam<const char*> {};

TEST_P(Golden, GivesTheReportItGave) {
  const std::string name = std::string("golden/") + GetParam();
  const Record record = read_record(data_file(name + ".json"));
  EXPECT_EQ(record.version, std::string_view(GetParam()).substr(0, record.version.size()));
  const std::string report = to_markdown(make_report(record));
  if (std::getenv("DESMO_UPDATE_GOLDEN")) std::ofstream(data_file(name + ".md")) << report;
  EXPECT_EQ(report, read_text(data_file(name + ".md")));
}

INSTANTIATE_TEST_SUITE_P(Minors, Golden, ::testing::ValuesIn(records), [](const auto& record) {
  std::string name = record.param;
  for (char& c : name)
    if (c == '.' || c == '-') c = '_';
  return "v" + name;
});

TEST(GoldenRecords, WereRecordedWithWhatTheirMinorHas) {
  for (const char* minor : minors) {
    const Record record = read_record(data_file(std::string("golden/") + minor + ".json"));
    const std::string version = minor;
    EXPECT_EQ(record.settings.allowed.has_value(), version >= "1.1.0") << minor;
    EXPECT_EQ(record.structure.empty(), version < "1.2.0") << minor;
    EXPECT_EQ(record.settings.reducer.has_value(), version >= "1.3.0") << minor;
    EXPECT_EQ(record.build.binary.has_value(), version >= "1.3.0") << minor;
    EXPECT_EQ(record.settings.windows.has_value(), version >= "1.4.0") << minor;
    EXPECT_EQ(has_samples_of_windows(record), version >= "1.6.0") << minor;
  }
}

TEST(GoldenRecords, OfPrecisionHavePointsAndWhatIsKnownOfTheirMotions) {
  const Record record = read_record(data_file("golden/1.5.0-precision.json"));
  EXPECT_FALSE(has_cells(record));
  EXPECT_FALSE(record.points.empty());
  EXPECT_FALSE(record.floors.empty());
  EXPECT_FALSE(read_record(data_file("golden/1.5.0-promises.json")).promises.empty());
  EXPECT_FALSE(read_record(data_file("golden/1.7.0-extremes.json")).extremes.empty());
}

TEST(GoldenRecords, SayWhichSolversMeasurementHasChosen) {
  const Record record = read_record(data_file("golden/1.10.0.json"));
  for (const auto& [key, cell] : record.cells)
    EXPECT_EQ(cell.solvers.empty(), !key.id.ends_with("_mixed")) << key.id;
}

TEST(GoldenRecords, OfSizesAndInstructionsHaveThem) {
  const Record sizes = read_record(data_file("golden/1.7.0-growth.json"));
  EXPECT_FALSE(has_cells(sizes));
  EXPECT_FALSE(sizes.growth.empty());
  EXPECT_FALSE(sizes.crossing.empty());
  EXPECT_FALSE(read_record(data_file("golden/1.7.0-instructions.json")).instructions.empty());
}

}  // namespace
}  // namespace desmo::report::golden_test
