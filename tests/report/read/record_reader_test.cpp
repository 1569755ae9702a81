#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <vector>

#include "report/formats/formats.h"
#include "report/read/record.h"
#include "report/read/record_file.h"
#include "report/report.h"
#include "tests/report/sample.h"

namespace desmo::report::record_reader_test {
namespace {

TEST(RecordReader, ReadsTheCompleteSample) {
  const Record record = read_record(data_file("complete.json"));
  EXPECT_EQ(record.settings.instants, 3001);
  EXPECT_EQ(record.candidates.size(), 5u * 16 + 6 * 5);
  EXPECT_EQ(record.profiles.size(), 3u);
  const MeasuredCandidate& candidate =
      record.candidates.at({"truck_suspension", 558, "group_symbolic_lapack"});
  EXPECT_EQ(candidate.status, Status::ok);
  EXPECT_EQ(candidate.time.seconds.size(), 5u);
}

TEST(RecordReader, RefusesWhatIsNotJson) {
  EXPECT_CONTAINS(complaint(read_text(data_file("truncated.json"))), "is the file truncated?");
  EXPECT_CONTAINS(complaint(std::string()), "the text is empty");
  EXPECT_CONTAINS(complaint(std::string("coordinates,FBL-G\n114,0.045\n")), "line 1, column 1: ");
  EXPECT_CONTAINS(complaint(std::string("\"\xff\"")), "the text is not UTF-8");
  EXPECT_CONTAINS(complaint(std::string("[1]")), "top level: is a list; give an object");
}

// Every prefix of a valid record is invalid, and says so without any other trouble.
TEST(RecordReader, RefusesEveryPrefix) {
  const std::string text = read_text(data_file("complete.json"));
  const std::size_t end = text.find_last_of('}');
  for (std::size_t length = 0; length <= end; length += 97)
    EXPECT_NE(complaint(text.substr(0, length)), "accepted") << length;
}

TEST(RecordReader, ReadsOneMajorVersionAndSaysWhatToDoWithOthers) {
  EXPECT_EQ(complaint(read_text(data_file("unknown_version.json"))),
            "/schema_version: schema version 3.0.0, and this program reads 2.x; update desmo and "
            "build it again");
  Json json = complete_record();
  json["schema"] = "google-benchmark";
  EXPECT_CONTAINS(complaint(json), "/schema: \"google-benchmark\" is not \"desmo-results\"");
  json = complete_record();
  json["schema_version"] = 1;
  EXPECT_CONTAINS(complaint(json), "/schema_version: is a number; give a text");
  json.erase("schema_version");
  EXPECT_CONTAINS(complaint(json), "the key 'schema_version' is missing");
  const Json old{{"schema", "desmo-results"}, {"version", "1.10.0"}, {"cells", Json::array()}};
  EXPECT_EQ(complaint(old),
            "/version: schema version 1.10.0, and this program reads 2.x; measure it anew "
            "(bench/run, bench/check --renew-baseline), or read it with desmo_report of the commit "
            "that it names");
  EXPECT_THROW(record_from(old), UnsupportedVersion);
  for (const char* text : {"", "2", "2.0", "2.0.0.0", "2.0.0-beta", "2..0", "2.0.", " 2.0.0",
                           "2.-1.0", "99999999999.0.0", "two"}) {
    json = complete_record();
    json["schema_version"] = text;
    EXPECT_CONTAINS(complaint(json),
                    "/schema_version: \"" + std::string(text) + "\" is not a version, as 2.0.0");
  }
}

// What a newer minor version adds is ignored, and its numbers are the same.
TEST(RecordReader, ReadsANewerMinorVersionWithANote) {
  Json json = complete_record();
  EXPECT_EQ(note_on_version(record_from(json).version), "");
  const auto of_best = [](const Json& from) {
    return to_csv(table_named(make_report(record_from(from)), "best"));
  };
  const std::string expected = of_best(json);
  for (const char* version : {"2.0.1", "2.7.0", "2.10.3"}) {
    json["schema_version"] = version;
    json["paper"]["cells"][0]["added"] = {{"key", 1}};
    json["another experiment"] = Json::array();
    EXPECT_EQ(of_best(json), expected);
    const Record record = record_from(json);
    const std::string note =
        "schema version " + std::string(version) + ", this program knows 2.0.0";
    EXPECT_CONTAINS(note_on_version(record.version), note);
    EXPECT_CONTAINS(to_markdown(make_report(record)), note);
  }
}

TEST(RecordReader, IgnoresKeysThatItDoesNotKnow) {
  Json json = complete_record();
  json["later"] = {{"key", 1}};
  json["paper"]["cells"][0]["cache_misses"] = {1, 2};
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, NamesTheMissingKey) {
  for (const char* key : {"schema", "schema_version", "record"}) {
    Json json = complete_record();
    json.erase(key);
    EXPECT_CONTAINS(complaint(json), "top level: the key '" + std::string(key) + "' is missing");
  }
  Json json = complete_record();
  json["record"]["settings"].erase("instants");
  EXPECT_CONTAINS(complaint(json), "/record/settings: the key 'instants' is missing");
  json = complete_record();
  json["paper"]["cells"][3].erase("time");
  EXPECT_CONTAINS(complaint(json), "/paper/cells/3: the key 'time' is missing");
  json = complete_record();
  json["paper"]["cells"][3]["time"].erase("clock");
  EXPECT_CONTAINS(complaint(json), "/paper/cells/3/time: the key 'clock' is missing");
  json = complete_record();
  json["paper"]["profiles"][1]["time_per_step"]["phases"].erase("solve");
  EXPECT_CONTAINS(complaint(json),
                  "/paper/profiles/1/time_per_step/phases: the key 'solve' is missing");
}

TEST(RecordReader, RefusesNotANumberAndInfinity) {
  const std::string text = complete_record().dump();
  for (const char* value : {"NaN", "Infinity", "1e999"}) {
    std::string changed = text;
    const std::size_t at = changed.find("\"seconds\":[") + 11;
    changed.replace(at, changed.find(',', at) - at, value);
    EXPECT_CONTAINS(complaint(changed), "line 1, column ");
  }
}

TEST(RecordReader, RefusesWrongTypesAndValues) {
  const auto with = [](const char* pointer, Json value) {
    Json json = complete_record();
    json[Json::json_pointer(pointer)] = std::move(value);
    return complaint(json);
  };
  EXPECT_CONTAINS(with("/record/dirty", 0), "/record/dirty: is a number; give true or false");
  EXPECT_CONTAINS(with("/record/blas/threads", 1.5),
                  "/record/blas/threads: must be a whole number");
  EXPECT_CONTAINS(with("/record/settings/instants", 0),
                  "/record/settings/instants: must be a whole number from 1");
  EXPECT_CONTAINS(with("/record/settings/tolerance", -1),
                  "/record/settings/tolerance: is negative");
  EXPECT_CONTAINS(with("/paper/cells/0/coordinates", 18446744073709551615u),
                  "/paper/cells/0/coordinates: ");
  EXPECT_CONTAINS(with("/paper/cells/0/status", "great"),
                  "/paper/cells/0/status: \"great\" is none of");
  EXPECT_CONTAINS(with("/paper/cells/0/case", "../escape"),
                  "/paper/cells/0/case: \"../escape\" is not a name");
  EXPECT_CONTAINS(with("/paper/cells/0/verification/position", -1),
                  "/paper/cells/0/verification/position: is negative");
  EXPECT_CONTAINS(with("/paper/cells/0/iterations_per_step", 1e200), "number is too large");
  EXPECT_CONTAINS(with("/paper/cells", Json::object()), "/paper/cells: is an object; give a list");
  EXPECT_CONTAINS(with("/record/libraries/KLU", 2),
                  "/record/libraries/KLU: is a number; give a text");
}

TEST(RecordReader, RefusesDatesThatThereAreNot) {
  for (const char* date : {"", "yesterday", "2026-11-21", "2026-13-01T00:00:00Z",
                           "2026-11-21T24:00:00Z", "2026-11-21T17:48:47", "2026-11-21 17:48:47Z",
                           "2026-11-21T-1:48:47Z", "9999-99-99T99:99:99Z"}) {
    Json json = complete_record();
    json["record"]["date"] = date;
    EXPECT_CONTAINS(complaint(json), "/record/date: \"" + std::string(date) + "\" is not a date");
  }
  Json json = complete_record();
  json["record"]["date"] = "2028-02-29T23:59:60Z";
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, RefusesInstantsThatDoNotMakeTheMotion) {
  for (const int instants : {2, 3000, 3002, 999'999'999}) {
    Json json = complete_record();
    json["record"]["settings"]["instants"] = instants;
    EXPECT_CONTAINS(complaint(json), "/record/settings/instants: " + std::to_string(instants) +
                                         " instants do not make 30 s in steps of 0.01 s");
  }
}

TEST(RecordReader, RefusesARecordOfNothing) {
  Json json = complete_record();
  json["paper"]["cells"] = Json::array();
  EXPECT_CONTAINS(complaint(json), "top level: nothing was measured");
  json = structured_record();
  json["paper"]["cells"] = Json::array();  // requests alone are something
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, RefusesWhatIsGivenTwice) {
  Json json = complete_record();
  json["paper"]["cells"].push_back(json["paper"]["cells"][0]);
  EXPECT_CONTAINS(complaint(json), "truck_suspension/114/global_automatic_cholmod is given twice");
  json = complete_record();
  json["paper"]["profiles"].push_back(json["paper"]["profiles"][0]);
  EXPECT_CONTAINS(complaint(json), "/paper/profiles/3: truck_suspension/558/");
  EXPECT_CONTAINS(complaint(std::string(R"({"schema": "a", "schema": "b"})")),
                  "/schema: the key is given twice");
}

TEST(RecordReader, ReadsWhatAMeasurementIsOf) {
  const Record record = read_record(data_file("origins.json"));
  ASSERT_TRUE(record.build.link);
  EXPECT_TRUE(record.build.link->starts_with("dynamic"));
  for (const auto& [key, candidate] : record.candidates) {
    if (candidate.status != Status::ok) continue;
    EXPECT_EQ(candidate.origin.machine, record.machine.cpu);
    EXPECT_EQ(candidate.origin.model->size(), 64u);
    EXPECT_EQ(candidate.origin.results->size(), 64u);
  }
  ASSERT_FALSE(record.requests.empty());
  EXPECT_TRUE(record.requests.front().solved.origin.model);
}

Json newest_record() { return Json::parse(read_text(data_file("origins.json"))); }

TEST(RecordReader, ReadsCompressedRecords) {
  const Record plain = read_record(data_file("complete.json"));
  const auto folder = std::filesystem::path(testing::TempDir());
  const std::string packed = (folder / "desmo_complete.json.gz").string();
  ASSERT_EQ(std::system(("gzip -c " + data_file("complete.json").string() + " >" + packed).c_str()),
            0);
  const Record record = read_record(packed);
  EXPECT_EQ(record.candidates.size(), plain.candidates.size());
  EXPECT_EQ(record.candidates.begin()->second.time.seconds,
            plain.candidates.begin()->second.time.seconds);
  std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
  try {
    read_record(packed);
    ADD_FAILURE() << "accepted";
  } catch (const InputError& error) {
    EXPECT_CONTAINS(std::string(error.what()), ": not complete compressed data (gzip)");
  }
  std::filesystem::remove(packed);
}

TEST(RecordReader, RefusesDigestsItDoesNotKnow) {
  Json json;
  for (const std::string bad : {"", "12ab", "G"}) {
    json = newest_record();
    json["paper"]["cells"][0]["model"] = bad;
    EXPECT_CONTAINS(complaint(json),
                    "/paper/cells/0/model: \"" + bad + "\" is not a SHA-256 digest");
  }
}

// Candidates of two records put together, by whatever shows that they are.
TEST(RecordReader, RefusesARecordOfTwoOrigins) {
  const std::string other(64, 'f');
  Json json = newest_record();
  json["paper"]["cells"][1]["machine"] = "Other CPU";
  EXPECT_CONTAINS(complaint(json), ": measured on \"Other CPU\", the record on \"");
  EXPECT_THROW(record_from(json), MixedRecord);
  json = newest_record();
  json["paper"]["requests"][0]["machine"] = "Other CPU";
  EXPECT_CONTAINS(complaint(json), "/request:damper: measured on");
  json = newest_record();
  json["paper"]["cells"][1]["model"] = other;
  EXPECT_CONTAINS(complaint(json), " solves another model than ");
  json = newest_record();
  json["paper"]["cells"][1]["results"] = other;
  EXPECT_CONTAINS(complaint(json), " has other results than ");
  json["paper"]["cells"][1]["status"] = "failed";  // then they are expected to differ
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, RefusesEndlessNestingAndSize) {
  EXPECT_CONTAINS(complaint(std::string(1'000'000, '[')), "nested more than 32 levels deep");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += "{\"a\":";
  EXPECT_CONTAINS(complaint(objects), "nested more than 32 levels deep");
  try {
    read_record("/dev/zero");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_CONTAINS(std::string(error.what()), "is not a regular file");
  }
  EXPECT_THROW(read_record("/nowhere/record.json"), InputError);
  EXPECT_THROW(read_record(data_file(".")), InputError);
}

TEST(RecordReader, IgnoresTheTimesOfAFailedCell) {
  Json json = complete_record();
  fail_candidate(json, "four_bar", 114, "group_symbolic_inlined");
  const Record record = record_from(json);
  EXPECT_TRUE(
      record.candidates.at({"four_bar", 114, "group_symbolic_inlined"}).time.seconds.empty());
}

TEST(RecordReader, RefusesAnOkCellWithoutVerification) {
  Json json = complete_record();
  json["paper"]["cells"][3].erase("verification");
  EXPECT_CONTAINS(complaint(json), "/paper/cells/3: an \"ok\" cell needs \"verification\"");
  json["paper"]["cells"][3]["status"] = "failed";
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, FailsTheCellThatExceedsWhatIsAllowed) {
  Json json = complete_record();
  Json& candidate = candidate_of(json, "truck_suspension", 558, "group_symbolic_lapack");
  const CandidateKey key{"truck_suspension", 558, "group_symbolic_lapack"};
  candidate["verification"]["velocity"] = 1e-8;  // the limit itself is allowed
  EXPECT_EQ(record_from(json).candidates.at(key).status, Status::ok);
  candidate["verification"]["velocity"] = 2e-6;
  candidate["verification"]["acceleration"] = 1;
  const MeasuredCandidate failed = record_from(json).candidates.at(key);
  EXPECT_EQ(failed.status, Status::failed);
  EXPECT_TRUE(failed.time.seconds.empty());
  EXPECT_EQ(failed.message,
            "velocity differs by 2e-06, 1e-08 is allowed; "
            "acceleration differs by 1, 1e-07 is allowed");
  json["record"]["settings"].erase("allowed");
  EXPECT_EQ(record_from(json).candidates.at(key).status, Status::ok);
}

TEST(RecordReader, NamesWhatIsWrongWithTheLimits) {
  Json json = complete_record();
  json["record"]["settings"]["allowed"]["velocity"] = 0;
  EXPECT_CONTAINS(complaint(json), "/record/settings/allowed/velocity: ");
  json["record"]["settings"]["allowed"].erase("velocity");
  EXPECT_CONTAINS(complaint(json), "/record/settings/allowed: the key 'velocity' is missing");
}

TEST(RecordReader, ReplacesControlCharacters) {
  Json json = complete_record();
  json["record"]["command"] = "desmo_bench\n\x1b[31m";
  const auto provenance = record_from(json).provenance;
  const std::pair<std::string, std::string> command{"command", "desmo_bench  [31m"};
  EXPECT_EQ(std::ranges::count(provenance, command), 1);
}

}  // namespace
}  // namespace desmo::report::record_reader_test
