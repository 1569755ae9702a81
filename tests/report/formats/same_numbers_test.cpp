// One record in CSV, Markdown and HTML: every number is that of its tables in all three. The
// files are read back by code that shares nothing with what wrote them.
#include <gtest/gtest-spi.h>
#include <gtest/gtest.h>

#include "report/formats/formats.h"
#include "report/read/record.h"
#include "report/read/record_file.h"
#include "report/report.h"
#include "tests/report/formats/reading.h"
#include "tests/report/points_sample.h"
#include "tests/report/sample.h"
#include "tests/report/size_sample.h"

namespace desmo::report::same_numbers_test {
namespace {

// Counts that people read in the notes below a table.
bool is_shown(const std::string& quantity) { return quantity != "repetitions"; }

// The fields of the CSV that hold an entry's quantities; returns what it must show.
std::vector<std::string> numbers_of(const Column& column, const Entry& entry,
                                    const std::vector<std::string>& fields, std::size_t& at) {
  std::vector<std::string> shown;
  for (std::size_t i = 0; i < column.quantities.size(); ++i) {
    const std::string& field = fields.at(at++);
    const std::string digits = i < entry.digits.size() ? entry.digits[i] : "";
    if (digits.empty()) {
      EXPECT_TRUE(field.empty() || field == entry.note) << field;
      continue;
    }
    EXPECT_EQ(field, digits);
    if (is_shown(column.quantities[i])) shown.push_back(field);
  }
  return shown;
}

// What is printed of an entry, less its note, which stands behind the numbers or before them.
std::vector<std::string> printed_numbers(std::string shown, const Entry& entry) {
  const std::string note = plain(entry.note);
  for (const std::string& end : {note, "(" + note + ")"})
    if (shown.ends_with(end)) return numbers_in(shown.substr(0, shown.size() - end.size()));
  if (shown.starts_with(note)) return numbers_in(shown.substr(note.size()));
  ADD_FAILURE() << shown << " does not say: " << note;
  return {};
}

void compare(const Table& table, const std::vector<std::vector<std::string>>& csv,
             const ReadTable& read, std::size_t& numbers) {
  SCOPED_TRACE(table.name);
  EXPECT_EQ(read.title, plain(table.title));
  ASSERT_EQ(read.rows.size(), table.rows.size() + 1);
  ASSERT_EQ(csv.size(), table.rows.size() + 1);
  for (std::size_t i = 0; i < table.rows.size(); ++i) {
    const std::vector<std::string>& shown = read.rows[i + 1];
    ASSERT_EQ(shown.size(), table.columns.size());
    std::size_t field = 0;
    for (std::size_t k = 0; k < shown.size(); ++k) {
      const Column& column = table.columns[k];
      const Entry& entry = table.rows[i][k];
      SCOPED_TRACE("row " + std::to_string(i + 1) + ", " + column.name);
      EXPECT_EQ(read.rows[0][k], plain(column.name));
      if (column.quantities.empty()) {
        EXPECT_EQ(shown[k], plain(entry.shown));
        EXPECT_EQ(csv[i + 1].at(field++), entry.shown);
        continue;
      }
      const std::vector<std::string> expected = numbers_of(column, entry, csv[i + 1], field);
      EXPECT_EQ(printed_numbers(shown[k], entry), expected) << shown[k];
      numbers += expected.size();
    }
  }
}

void expect_same_numbers(const Document& document, std::size_t min_numbers = 100) {
  const std::vector<NewFile> csv = render(document, "csv");
  for (const auto& read : {read_markdown(to_markdown(document)), read_html(to_html(document))}) {
    std::size_t at = 0, numbers = 0;
    const auto says = [&](const std::vector<std::string>& lines) {
      for (const std::string& line : lines)
        EXPECT_NE(read.text.find(plain(line)), std::string::npos) << line;
    };
    for (const Section& section : document.sections) {
      says(section.paragraphs);
      says(section.definitions);
      for (const Table& table : section.tables) {
        says(table.notes);
        ASSERT_LT(at, read.tables.size());
        ASSERT_EQ(csv[at].file_name, table.name + ".csv");
        compare(table, read_csv(csv[at].content), read.tables[at], numbers);
        ++at;
      }
    }
    EXPECT_EQ(at, read.tables.size());
    EXPECT_EQ(at, csv.size());
    EXPECT_GT(numbers, min_numbers);
  }
}

TEST(SameNumbers, OfARecordWithoutGaps) {
  expect_same_numbers(make_report(record_from(complete_record())));
}

TEST(SameNumbers, OfARecordWithFailures) {
  Json record = complete_record();
  fail_candidate(record, "truck_suspension", 336, "group_symbolic_lapack");
  set_samples(record, 114, "group_automatic_klu", {0.04});
  erase_candidate(record, "truck_suspension", 447, "group_automatic_klu");
  expect_same_numbers(make_report(record_from(record)));
}

TEST(SameNumbers, OfTimeAgainstError) {
  expect_same_numbers(make_report(record_from(points_record())));
}

TEST(SameNumbers, OfTimeAgainstSize) {
  expect_same_numbers(make_report(record_from(sizes_record())));
}

TEST(SameNumbers, OfInstructions) {
  expect_same_numbers(make_report(record_from(instructions_record())), 10);
}

TEST(SameNumbers, OfEveryFiledRun) {
  int runs = 0;
  for (const auto& file :
       std::filesystem::directory_iterator(DESMO_SOURCE_DIR "/results/records")) {
    SCOPED_TRACE(file.path());
    expect_same_numbers(make_report(read_record(file.path())), 50);
    ++runs;
  }
  EXPECT_GT(runs, 0);
}

// The comparison notices: a digit, a place and a table that differ in one format.
TEST(SameNumbers, DifferencesAreSeen) {
  Table table{.name = "one",
              .title = "One",
              .notes = {},
              .columns = {{"id", {}}, {"time", {"seconds", "half_range"}}},
              .rows = {{"a", {"1.50 ±0.10", {"1.50", "0.10"}, ""}}}};
  const auto csv = read_csv(to_csv(table));
  const auto differences = [&](ReadTable read) {
    ::testing::TestPartResultArray found;
    const ::testing::ScopedFakeTestPartResultReporter reporter(
        ::testing::ScopedFakeTestPartResultReporter::INTERCEPT_ONLY_CURRENT_THREAD, &found);
    std::size_t numbers = 0;
    compare(table, csv, read, numbers);
    return found.size();
  };
  EXPECT_EQ(differences({"One", {{"id", "time"}, {"a", "1.50 ±0.10"}}}), 0);
  EXPECT_EQ(differences({"One", {{"id", "time"}, {"a", "1.5 ±0.10"}}}), 1);
  EXPECT_EQ(differences({"One", {{"id", "time"}, {"a", "1.50"}}}), 1);
  EXPECT_EQ(differences({"Two", {{"id", "time"}, {"b", "1.50 ±0.10"}}}), 2);
}

}  // namespace
}  // namespace desmo::report::same_numbers_test
