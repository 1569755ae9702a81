#include "cases/io/text_file.h"
#include "report/formats/formats.h"
#include "tests/report/sample.h"
#include "tests/started.h"

namespace desmo::report::record_reader_test {
namespace {

TEST(RecordReader, SaysWhatToDoWithAnOldVersion) {
  const Json old{{"schema", "desmo-results"}, {"version", "1.10.0"}, {"candidates", Json::array()}};
  EXPECT_EQ(complaint(old),
            "/version: schema version 1.10.0, and this program reads " + versions_read() +
                "; measure it anew (bench/run, bench/check --renew-baseline), or read it with "
                "desmo_report of the commit that it names");
}

TEST(RecordReader, QuotesTheBeginningOfALongText) {
  const std::string big(5000, 'x'), shown = big.substr(0, 60) + "...";
  for (const char* place : {"/schema", "/schema_version", "/paper/candidates/0/status",
                            "/paper/candidates/0/case", "/paper/candidates/0/model"}) {
    const std::string said = complaint(changed(complete_record(), place, big + " y"));
    EXPECT_CONTAINS(said, "\"" + shown + "\" is n");
    EXPECT_LT(said.size(), 500u) << place;
  }
  const std::string far = "9." + std::string(5000, '0') + ".0";
  EXPECT_LT(complaint(changed(complete_record(), "/schema_version", far)).size(), 500u);
}

// Additions of a newer minor version are ignored, and the numbers are the same.
TEST(RecordReader, ReadsANewerMinorVersionWithANote) {
  Json json = complete_record();
  EXPECT_EQ(note_on_version(record_from(json).version), "");
  const std::string expected = to_csv(table_of(json, "best"));
  for (const std::string& version :
       {later_version(0, 0, 1), later_version(0, 7, 0), later_version(0, 10, 3)}) {
    json["schema_version"] = version;
    json["paper"]["candidates"][0]["added"] = {{"key", 1}};
    json["another experiment"] = Json::array();
    EXPECT_EQ(to_csv(table_of(json, "best")), expected);
    const Record record = record_from(json);
    const std::string note = "schema version " + version + ", this program knows " + schema_version;
    EXPECT_CONTAINS(note_on_version(record.version), note);
    EXPECT_CONTAINS(to_markdown(make_report(record)), note);
  }
}

// The version stands in schema_version.h; the schemas allow it.
TEST(RecordReader, KnowsTheVersionOfTheSchemas) {
  const std::filesystem::path results = std::filesystem::path(DESMO_SOURCE_DIR) / "results";
  const auto version_in = [&](const char* schema) -> Json {
    return Json::parse(read_text(results / schema))["properties"]["schema_version"];
  };
  EXPECT_EQ(version_in("record.schema.json")["enum"].back(), schema_version);
  EXPECT_EQ(version_in("check.schema.json")["$ref"],
            "record.schema.json#/properties/schema_version");
}

TEST(RecordReader, RefusesWrongTypesAndValues) {
  std::vector<Refusal> refusals{
      {"", Json::array({1}), "top level: is a list; give an object"},
      {"/schema", removed, "top level: the key 'schema' is missing"},
      {"/schema_version", removed, "top level: the key 'schema_version' is missing"},
      {"/record", removed, "top level: the key 'record' is missing"},
      {"/record/settings/instants", removed, "/record/settings: the key 'instants'"},
      {"/record/settings/allowed/velocity", removed, "/allowed: the key 'velocity'"},
      {"/paper/candidates/3/time", removed, "/paper/candidates/3: the key 'time'"},
      {"/paper/candidates/3/time/clock", removed, "/paper/candidates/3/time: the key 'clock'"},
      {"/paper/candidates/3/verification", removed,
       "/paper/candidates/3: an \"ok\" candidate needs \"verification\""},
      {"/paper/profiles/1/time_per_step/phases/solve", removed, "/phases: the key 'solve'"},
      {"/schema_version", later_version(1, 0, 0),
       ": schema version " + later_version(1, 0, 0) + ", and this program reads " +
           versions_read() + "; update desmo and build it"},
      {"/schema", "google-benchmark", ": \"google-benchmark\" is not \"desmo-results\""},
      {"/record/dirty", 0, ": is a number; give true or false"},
      {"/record/blas/threads", 1.5, ": must be a whole number"},
      {"/record/settings/instants", 0, ": must be a whole number from 1"},
      {"/record/settings/tolerance", -1, ": is negative"},
      {"/record/settings/allowed/velocity", 0, ": "},
      {"/paper/candidates", Json::array(), "top level: nothing was measured"},
      {"/paper/candidates/0/coordinates", 18446744073709551615u, ": "},
      {"/paper/candidates/0/status", "great", ": \"great\" is none of"},
      {"/paper/candidates/0/case", "../escape", ": \"../escape\" is not a name"},
      {"/paper/candidates/0/verification/position", -1, ": is negative"},
      {"/paper/candidates/0/iterations_per_step", 1e200, "number is too large"},
      {"/paper/candidates/-", complete_record()["paper"]["candidates"][0],
       "truck_suspension/114/global_automatic_cholmod is given twice"},
      {"/paper/profiles/-", complete_record()["paper"]["profiles"][0],
       "/paper/profiles/3: truck_suspension/558/"}};
  for (const std::string id : {"a_b_c/threads:x", "a_b_c/threads:2x", "a_b_c/threads:99999999999"})
    refusals.push_back({"/paper/candidates/0/id", id, ": \"" + id + "\" has no number of threads"});
  for (const std::string digest : {"", "12ab", "G"})
    refusals.push_back(
        {"/paper/candidates/0/model", digest, ": \"" + digest + "\" is not a SHA-256 digest"});
  for (const std::string date :
       {"", "yesterday", "2026-11-21", "2026-13-01T00:00:00Z", "2026-11-21T24:00:00Z",
        "2026-11-21T17:48:47", "2026-11-21 17:48:47Z", "2026-11-21T-1:48:47Z",
        "9999-99-99T99:99:99Z"})
    refusals.push_back({"/record/date", date, ": \"" + date + "\" is not a date"});
  for (const int instants : {2, 3000, 3002, 999'999'999})
    refusals.push_back(
        {"/record/settings/instants", instants,
         ": " + std::to_string(instants) + " instants do not make 30 s in steps of 0.01 s"});
  for (const std::string version : {"", "2", "2.0", "2.0.0.0", "2.0.0-beta", "2..0", "2.0.",
                                    " 2.0.0", "2.-1.0", "99999999999.0.0", "two"})
    refusals.push_back({"/schema_version", version,
                        ": \"" + version + "\" is not a version, as " + schema_version});
  expect_refusals(complete_record(), refusals);
}

TEST(RecordReader, ReadsALeapSecondAndRequestsAlone) {
  EXPECT_EQ(complaint(changed(complete_record(), "/record/date", "2028-02-29T23:59:60Z")),
            "accepted");
  EXPECT_EQ(complaint(changed(requests_record(), "/paper/candidates", Json::array())), "accepted");
}

using CompressedRecord = InFolder;

TEST_F(CompressedRecord, IsReadLikeAPlainOne) {
  const Record plain = read_record(data_file("complete.json"));
  const std::string packed = file("complete.json.gz");
  ASSERT_EQ(shell("gzip -c " + data_file("complete.json").string() + " >" + packed), 0);
  const Record record = read_record(packed);
  EXPECT_EQ(record.candidates.size(), plain.candidates.size());
  EXPECT_EQ(record.candidates.begin()->second.time.seconds,
            plain.candidates.begin()->second.time.seconds);
  std::filesystem::resize_file(packed, std::filesystem::file_size(packed) / 2);
  EXPECT_CONTAINS(refusal<InputError>([&] { read_record(packed); }),
                  ": not complete compressed data (gzip)");
}

// Candidates of two records put together, by whatever shows that they are.
TEST(RecordReader, RefusesARecordOfTwoOrigins) {
  const std::string other(64, 'f');
  expect_refusals(
      origins_record(),
      {{"/paper/candidates/1/machine", "Other CPU", "measured on \"Other CPU\", the record on \""},
       {"/paper/requests/0/machine", "Other CPU", "/request:damper: measured on"},
       {"/paper/candidates/1/model", other, " solves another model than "},
       {"/paper/candidates/1/results", other, " has other results than "}});
  Json json = changed(origins_record(), "/paper/candidates/1/results", other);
  EXPECT_THROW(record_from(json), MixedRecord);
  json["paper"]["candidates"][1]["status"] = "failed";  // then they are expected to differ
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, FailsTheCandidateThatExceedsWhatIsAllowed) {
  Json json = complete_record();
  Json& candidate = candidate_of(json, 558, "group_symbolic_lapack");
  const CandidateKey key{truck, 558, "group_symbolic_lapack"};
  candidate["verification"]["velocity"] = 1e-8;  // the limit itself is allowed
  EXPECT_EQ(record_from(json).candidates.at(key).status, Status::ok);
  candidate["verification"]["velocity"] = 2e-6;
  candidate["verification"]["acceleration"] = 1;
  const Measurement failed = record_from(json).candidates.at(key);
  EXPECT_EQ(failed.status, Status::failed);
  EXPECT_TRUE(failed.time.seconds.empty());
  EXPECT_EQ(failed.message,
            "velocity differs by 2e-06, 1e-08 is allowed; "
            "acceleration differs by 1, 1e-07 is allowed");
  json["record"]["settings"].erase("allowed");
  EXPECT_EQ(record_from(json).candidates.at(key).status, Status::ok);
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
