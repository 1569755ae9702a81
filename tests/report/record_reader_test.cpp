#include "report/record_reader.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/report/contains.h"
#include "tests/report/sample.h"

namespace desmo::report::record_reader_test {
namespace {

TEST(RecordReader, ReadsTheCompleteSample) {
  const Record record = read_record(data_file("complete.json"));
  EXPECT_EQ(record.settings.instants, 3001);
  EXPECT_EQ(record.cells.size(), 5u * 16 + 6 * 5);
  EXPECT_EQ(record.profiles.size(), 3u);
  const Cell& cell = record.cells.at({"truck_suspension", 558, "group_symbolic_lapack"});
  EXPECT_EQ(cell.status, Status::ok);
  EXPECT_EQ(cell.cpu_seconds.size(), 5u);
}

TEST(RecordReader, RefusesWhatIsNotJson) {
  EXPECT_CONTAINS(complaint(read_text(data_file("truncated.json"))),
                  "not a complete JSON document");
  EXPECT_CONTAINS(complaint(std::string()), "not a complete JSON document");
  EXPECT_CONTAINS(complaint(std::string("coordinates,FBL-G\n114,0.045\n")), "not a complete JSON");
  EXPECT_CONTAINS(complaint(std::string("\"\xff\"")), "not a complete JSON document");
  EXPECT_CONTAINS(complaint(std::string("[1]")), "top level: an object was expected, not array");
}

// Every prefix of a valid record is invalid, and says so without any other trouble.
TEST(RecordReader, RefusesEveryPrefix) {
  const std::string text = read_text(data_file("complete.json"));
  const std::size_t end = text.find_last_of('}');
  for (std::size_t length = 0; length <= end; length += 97)
    EXPECT_NE(complaint(text.substr(0, length)), "accepted") << length;
}

TEST(RecordReader, RefusesAnotherSchemaOrMajorVersion) {
  EXPECT_CONTAINS(complaint(read_text(data_file("unknown_version.json"))),
                  "version: schema version 2.0.0 is not supported, only 1.x.y");
  Json json = complete_record();
  json["schema"] = "google-benchmark";
  EXPECT_CONTAINS(complaint(json), "schema: \"google-benchmark\" is not \"desmo-results\"");
  for (const char* version :
       {"1", "1.0", "1.0.0.0", "1.0.0-rc1", "one", "", "1..0", "-1.0.0", "99999999999.0.0"}) {
    json = complete_record();
    json["version"] = version;
    EXPECT_CONTAINS(complaint(json), "is not a version of the form 1.2.3");
  }
  json["version"] = 1;
  EXPECT_CONTAINS(complaint(json), "version: a string was expected, not number");
}

TEST(RecordReader, SaysThatAFutureVersionNeedsANewerReport) {
  Json json = complete_record();
  json["version"] = "2.0.0";
  EXPECT_CONTAINS(complaint(json), "; a newer desmo_report reads it");
  json["version"] = "0.9.0";
  EXPECT_EQ(complaint(json), "version: schema version 0.9.0 is not supported, only 1.x.y");
}

TEST(RecordReader, ReadsANewerMinorVersionWithUnknownKeys) {
  Json json = complete_record();
  json["version"] = "1.7.3";
  json["later"] = {{"key", 1}};
  json["cells"][0]["cache_misses"] = {1, 2};
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, NamesTheMissingKey) {
  for (const char* key : {"schema", "version", "record", "cells"}) {
    Json json = complete_record();
    json.erase(key);
    EXPECT_CONTAINS(complaint(json),
                    "top level: the required key \"" + std::string(key) + "\" is missing");
  }
  Json json = complete_record();
  json["record"]["settings"].erase("instants");
  EXPECT_CONTAINS(complaint(json), "record.settings: the required key \"instants\" is missing");
  json = complete_record();
  json["cells"][3].erase("cpu_seconds");
  EXPECT_CONTAINS(complaint(json), "cells[3]: the required key \"cpu_seconds\" is missing");
  json = complete_record();
  json["profiles"][1]["seconds_per_step"].erase("solve");
  EXPECT_CONTAINS(complaint(json),
                  "profiles[1].seconds_per_step: the required key \"solve\" is missing");
}

TEST(RecordReader, RefusesSamplesThatAreNoTimes) {
  for (const char* sample : {"0", "-0.1", "1e-30", "1e30", "\"0.1\"", "null", "[0.1]"}) {
    Json json = complete_record();
    json["cells"][2]["cpu_seconds"][1] = Json::parse(sample);
    EXPECT_CONTAINS(complaint(json), "cells[2].cpu_seconds[1]: ");
  }
  Json json = complete_record();
  json["cells"][2]["cpu_seconds"] = Json::array();
  EXPECT_CONTAINS(complaint(json), "cells[2].cpu_seconds: an \"ok\" cell needs");
}

TEST(RecordReader, RefusesNotANumberAndInfinity) {
  const std::string text = complete_record().dump();
  for (const char* value : {"NaN", "Infinity", "1e999"}) {
    std::string changed = text;
    const std::size_t at = changed.find("\"cpu_seconds\":[") + 15;
    changed.replace(at, changed.find(',', at) - at, value);
    EXPECT_CONTAINS(complaint(changed), "not a complete JSON document");
  }
}

TEST(RecordReader, RefusesWrongTypesAndValues) {
  const auto with = [](const char* pointer, Json value) {
    Json json = complete_record();
    json[Json::json_pointer(pointer)] = std::move(value);
    return complaint(json);
  };
  EXPECT_CONTAINS(with("/record/dirty", 0), "record.dirty: true or false was expected");
  EXPECT_CONTAINS(with("/record/blas/threads", 1.5), "record.blas.threads: an integer");
  EXPECT_CONTAINS(with("/record/settings/instants", 0), "record.settings.instants: 0 is not in 1");
  EXPECT_CONTAINS(with("/record/settings/tolerance", -1), "record.settings.tolerance: -1 is");
  EXPECT_CONTAINS(with("/cells/0/coordinates", 18446744073709551615u), "cells[0].coordinates: ");
  EXPECT_CONTAINS(with("/cells/0/status", "great"), "cells[0].status: \"great\" is none of");
  EXPECT_CONTAINS(with("/cells/0/case", "../escape"), "cells[0].case: \"../escape\" is not a name");
  EXPECT_CONTAINS(with("/cells/0/verification/position", -1), "cells[0].verification.position: -1");
  EXPECT_CONTAINS(with("/cells/0/residual", 1e200), "cells[0].residual: ");
  EXPECT_CONTAINS(with("/cells/0/solvers", {{{"algebra", "klu"}, {"parts", 1}, {"unknowns", {4}}}}),
                  "cells[0].solvers[0].unknowns: ");
  EXPECT_CONTAINS(with("/cells", Json::object()), "cells: an array was expected, not object");
  EXPECT_CONTAINS(with("/record/libraries/KLU", 2), "record.libraries.KLU: a string was expected");
}

TEST(RecordReader, RefusesDatesThatThereAreNot) {
  for (const char* date :
       {"", "yesterday", "2026-11-21", "2026-13-01T00:00:00Z", "2026-02-29T00:00:00Z",
        "2026-11-21T24:00:00Z", "2026-11-21T17:48:47", "2026-11-21 17:48:47Z",
        "2026-11-21T-1:48:47Z", "9999-99-99T99:99:99Z"}) {
    Json json = complete_record();
    json["record"]["date"] = date;
    EXPECT_CONTAINS(complaint(json), "record.date: \"" + std::string(date) + "\" is not a date");
  }
  Json json = complete_record();
  json["record"]["date"] = "2028-02-29T23:59:60Z";
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, RefusesInstantsThatDoNotMakeTheMotion) {
  for (const int instants : {2, 3000, 3002, 999'999'999}) {
    Json json = complete_record();
    json["record"]["settings"]["instants"] = instants;
    EXPECT_CONTAINS(complaint(json), "record.settings.instants: " + std::to_string(instants) +
                                         " instants do not make 30 s in steps of 0.01 s");
  }
}

TEST(RecordReader, RefusesARecordOfNothing) {
  Json json = complete_record();
  json["cells"] = Json::array();
  EXPECT_CONTAINS(complaint(json), "cells: the record has no cell");
  json = structured_record();
  json["cells"] = Json::array();  // requests alone are something
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, RefusesWhatIsGivenTwice) {
  Json json = complete_record();
  json["cells"].push_back(json["cells"][0]);
  EXPECT_CONTAINS(complaint(json), "truck_suspension/114/global_automatic_cholmod is given twice");
  json = complete_record();
  json["profiles"].push_back(json["profiles"][0]);
  EXPECT_CONTAINS(complaint(json), "profiles[3]: truck_suspension/558/");
  EXPECT_CONTAINS(complaint(std::string(R"({"schema": "a", "schema": "b"})")),
                  "the key \"schema\" is given twice");
}

TEST(RecordReader, ReadsWhatAMeasurementIsOf) {
  const Record record = read_record(data_file("golden/1.3.0.json"));
  EXPECT_EQ(record.machine.turbo, "unknown");
  ASSERT_TRUE(record.build.link);
  EXPECT_EQ(record.build.link->type, "dynamic");
  EXPECT_FALSE(record.build.link->libraries.empty());
  EXPECT_EQ(record.build.binary->size(), 64u);
  EXPECT_EQ(record.settings.reducer, "median");
  for (const auto& [key, cell] : record.cells) {
    if (cell.status != Status::ok) continue;
    EXPECT_EQ(cell.origin.machine, record.machine.cpu);
    EXPECT_EQ(cell.origin.model->size(), 64u);
    EXPECT_EQ(cell.origin.results->size(), 64u);
  }
  ASSERT_FALSE(record.requests.empty());
  EXPECT_TRUE(record.requests.front().origin.model);
}

Json newest_record() { return Json::parse(read_text(data_file("golden/1.3.0.json"))); }

TEST(RecordReader, RefusesSamplesThatWereLost) {
  Json json = newest_record();
  json["cells"][0]["cpu_seconds"].erase(0);
  EXPECT_CONTAINS(complaint(json), "cells[0].cpu_seconds: 6 samples of 7");
  json = newest_record();
  json["requests"][0]["cpu_seconds"].push_back(1);
  EXPECT_CONTAINS(complaint(json), "requests[0].cpu_seconds: 8 samples of 7");
}

TEST(RecordReader, ReadsTheSegmentsOfEverythingTimed) {
  const Record record = record_from(with_windows(structured_record()));
  EXPECT_EQ(record.settings.windows, 25);
  for (const auto& [key, cell] : record.cells)
    EXPECT_EQ(cell.segments.least.size(), cell.status == Status::ok ? 25u : 0u) << key.id;
  for (const Request& request : record.requests)
    EXPECT_EQ(request.segments.least.size(), request.status == Status::ok ? 25u : 0u);
  EXPECT_TRUE(record_from(structured_record()).cells.begin()->second.segments.least.empty());
}

/// And leaves alone what they say of segments, if that is no more than a repetition.
TEST(RecordReader, TakesAsAWholeWhatSeveralThreadsSolve) {
  Json json = with_windows(complete_record());
  json["cells"][3]["threads"] = 2;
  const std::vector<double> seconds = json["cells"][3]["cpu_seconds"];
  const Record record = record_from(json);
  int of_threads = 0;
  for (const auto& [key, cell] : record.cells)
    if (cell.segments.samples.size() == seconds.size()) {
      ++of_threads;
      EXPECT_EQ(key.id, json["cells"][3]["id"]);
      EXPECT_EQ(cell.cpu_seconds, seconds);
      for (std::size_t r = 0; r < seconds.size(); ++r)
        EXPECT_EQ(cell.segments.samples[r], std::vector{seconds[r]});
      EXPECT_DOUBLE_EQ(undisturbed(cell.segments), std::ranges::min(seconds));
    }
  EXPECT_EQ(of_threads, 1);
  json["cells"][3]["segment_seconds"][7] = 100;
  EXPECT_CONTAINS(complaint(json), "together they are longer than");
}

TEST(RecordReader, RefusesSegmentsThatAreNotAll) {
  const Json record = with_windows(complete_record());
  Json json = record;
  json["cells"][3]["segment_seconds"].erase(7);
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_seconds: 24 segments of 25");
  json["cells"][3].erase("segment_seconds");
  EXPECT_CONTAINS(complaint(json), "cells[3]: the required key \"segment_seconds\" is missing");
  json = record;
  json["cells"][3]["segment_seconds"][7] = 0;
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_seconds[7]: ");
  json["cells"][3]["segment_seconds"][7] = 100;
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_seconds: together they are longer than");
  json = record;
  json["record"]["settings"]["segments"] = 1;
  EXPECT_CONTAINS(complaint(json), "record.settings.windows: 1 is not in 2");
}

TEST(RecordReader, ReadsTheSamplesOfSegments) {
  const Record record = record_from(with_samples_of_windows(structured_record()));
  for (const auto& [key, cell] : record.cells) {
    EXPECT_EQ(cell.segments.samples.size(), cell.cpu_seconds.size()) << key.id;
    if (cell.status != Status::ok) continue;
    EXPECT_EQ(cell.segments.updates.size(), 25u);
    EXPECT_EQ(std::accumulate(cell.segments.instants.begin(), cell.segments.instants.end(), 0.0),
              static_cast<double>(record.settings.instants));
  }
}

TEST(RecordReader, RefusesSamplesOfSegmentsThatDoNotBelongTogether) {
  const Json record = with_samples_of_windows(complete_record());
  Json json = record;
  json["cells"][3]["segment_samples"][0].erase(7);
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_samples[0]: 24 segments of 25");
  json = record;
  json["cells"][3]["segment_updates"].push_back(1);
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_updates: 26 segments of 25");
  json = record;
  json["cells"][3]["segment_updates"][2] = -1;
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_updates[2]: ");
  json = record;
  json["cells"][3].erase("segment_updates");
  EXPECT_CONTAINS(complaint(json), "the required key \"segment_updates\" is missing");
  json = record;
  for (Json& sample : json["cells"][3]["segment_samples"]) sample[7] = 0.5;
  EXPECT_CONTAINS(complaint(json), "segment 7 is not the least of its samples");
  json = record;
  json["cells"][3]["segment_samples"] = Json::array();
  EXPECT_CONTAINS(complaint(json), "cells[3].segment_samples: there is none");
}

TEST(RecordReader, RefusesAReducerAndDigestsItDoesNotKnow) {
  Json json = newest_record();
  json["record"]["settings"]["reducer"] = "minimum";
  EXPECT_CONTAINS(complaint(json), "record.settings.reducer: \"minimum\" is not \"median\"");
  for (const std::string bad : {"", "12ab", "G"}) {
    json = newest_record();
    json["cells"][0]["model"] = bad;
    EXPECT_CONTAINS(complaint(json), "cells[0].model: \"" + bad + "\" is not a SHA-256 digest");
  }
}

// Cells of two records put together, by whatever shows that they are.
TEST(RecordReader, RefusesARecordOfTwoOrigins) {
  const std::string other(64, 'f');
  Json json = newest_record();
  json["cells"][1]["machine"] = "Other CPU";
  EXPECT_CONTAINS(complaint(json), ": measured on \"Other CPU\", the record on \"");
  EXPECT_THROW(record_from(json), MixedRecord);
  json = newest_record();
  json["requests"][0]["machine"] = "Other CPU";
  EXPECT_CONTAINS(complaint(json), "/request:damper: measured on");
  json = newest_record();
  json["cells"][1]["model"] = other;
  EXPECT_CONTAINS(complaint(json), " solves another model than ");
  json = newest_record();
  json["cells"][1]["results"] = other;
  EXPECT_CONTAINS(complaint(json), " has other results than ");
  json["cells"][1]["status"] = "failed";  // then they are expected to differ
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
  } catch (const InvalidRecord& error) {
    EXPECT_CONTAINS(std::string(error.what()), "larger than 67108864 bytes");
  }
  EXPECT_THROW(read_record("/nowhere/record.json"), InvalidRecord);
  EXPECT_THROW(read_record(data_file(".")), InvalidRecord);
}

TEST(RecordReader, IgnoresTheTimesOfAFailedCell) {
  Json json = complete_record();
  fail_cell(json, "four_bar", 114, "group_symbolic_inlined");
  const Record record = record_from(json);
  EXPECT_TRUE(record.cells.at({"four_bar", 114, "group_symbolic_inlined"}).cpu_seconds.empty());
}

TEST(RecordReader, RefusesAnOkCellWithoutVerification) {
  Json json = complete_record();
  json["cells"][3].erase("verification");
  EXPECT_CONTAINS(complaint(json), "cells[3]: an \"ok\" cell needs \"verification\"");
  json["cells"][3]["status"] = "failed";
  EXPECT_EQ(complaint(json), "accepted");
}

TEST(RecordReader, FailsTheCellThatExceedsWhatIsAllowed) {
  Json json = complete_record();
  Json& cell = cell_of(json, "truck_suspension", 558, "group_symbolic_lapack");
  const CellKey key{"truck_suspension", 558, "group_symbolic_lapack"};
  cell["verification"]["velocity"] = 1e-8;  // the limit itself is allowed
  EXPECT_EQ(record_from(json).cells.at(key).status, Status::ok);
  cell["verification"]["velocity"] = 2e-6;
  cell["verification"]["acceleration"] = 1;
  const Cell failed = record_from(json).cells.at(key);
  EXPECT_EQ(failed.status, Status::failed);
  EXPECT_TRUE(failed.cpu_seconds.empty());
  EXPECT_EQ(failed.message,
            "velocity differs by 2e-06, 1e-08 is allowed; "
            "acceleration differs by 1, 1e-07 is allowed");
  json["record"]["settings"].erase("allowed");
  EXPECT_EQ(record_from(json).cells.at(key).status, Status::ok);
}

TEST(RecordReader, NamesWhatIsWrongWithTheLimits) {
  Json json = complete_record();
  json["record"]["settings"]["allowed"]["velocity"] = 0;
  EXPECT_CONTAINS(complaint(json), "record.settings.allowed.velocity: ");
  json["record"]["settings"]["allowed"].erase("velocity");
  EXPECT_CONTAINS(complaint(json),
                  "record.settings.allowed: the required key \"velocity\" is missing");
}

TEST(RecordReader, ReadsTheRangeOfAProfile) {
  Json json = complete_record();
  EXPECT_EQ(complaint(json), "accepted");
  json["profiles"][0]["total_range"] = {2e-6, 1e-6};
  EXPECT_CONTAINS(complaint(json), "profiles[0].total_range: the smallest exceeds the largest");
  json["profiles"][0]["total_range"] = {1e-6};
  EXPECT_CONTAINS(complaint(json), "profiles[0].total_range: two numbers were expected");
  json["profiles"][0]["total_range"] = {1e-6, -1};
  EXPECT_CONTAINS(complaint(json), "profiles[0].total_range[1]: ");
}

TEST(RecordReader, ReplacesControlCharacters) {
  Json json = complete_record();
  json["record"]["command"] = "desmo_bench\n\x1b[31m";
  EXPECT_EQ(record_from(json).command, "desmo_bench  [31m");
}

}  // namespace
}  // namespace desmo::report::record_reader_test
