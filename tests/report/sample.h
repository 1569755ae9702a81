// The synthetic records of tests/report/data and functions that modify them.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/read/record.h"
#include "report/read/record_file.h"
#include "report/report.h"
#include "report/tables/tables.h"
#include "report/text/document.h"
#include "tests/contains.h"
#include "tests/refusal.h"
#include "tests/replaced.h"

namespace desmo::report {

using Json = nlohmann::ordered_json;

inline constexpr const char* truck = "truck_suspension";

std::filesystem::path data_file(const std::string& name);
std::size_t count(const std::string& text, const std::string& part);
/// Returns whether one of the texts contains a part.
bool says(const std::vector<std::string>& texts, const std::string& part);

/// Returns data/complete.json: every family and size, all of status "ok", with made-up numbers.
Json complete_record();

/// A small record among the data that has the machine, model and results of each candidate.
inline constexpr const char* origins = "golden/2.0.0.json";
Json origins_record();

/// Returns a record of schema 2, with its paper's experiment, in schema_version.
Json in_known_schema(Json record);

/// Returns schema_version with so much added to its major, minor and patch number.
std::string later_version(int major, int minor, int patch);

/// Returns the words of messages for the versions that are read: "2.x and 3.x".
std::string versions_read();

/// Stands for a value that a changed record does not have.
inline const Json removed(Json::value_t::discarded);

/// Returns a record with another value at a place, "/paper/candidates/0/status", or without it.
Json changed(Json record, const std::string& place, const Json& value);

/// Returns the record with timing windows: the smallest sample of each time is divided into windows
/// of increasing length.
Json with_windows(Json record, int windows = 25);

/// Returns the record with timing windows and their samples: each sample of a time is divided in
/// the same proportions. Updates grow from window to window.
Json with_samples_of_windows(Json record, int windows = 25);

/// Returns the numbers of a position, velocity and acceleration.
Json levels(double position, double velocity, double acceleration);

/// Returns three samples of CPU time: a time, 2 % more and 50 % more.
Json step_time(double microseconds);

/// Returns a record without any experiment.
Json empty_record();

/// Returns data/requests.json: small, with requests and made-up numbers.
Json requests_record();

/// Returns the first element of a list that has these members. Fails the test when there is none.
Json& element_with(Json& list, const Json& members);

/// Returns a truck candidate of a record. Fails the test when there is none.
Json& candidate_of(Json& record, int coordinates, const std::string& id);
void erase_candidate(Json& record, int coordinates, const std::string& id);
/// Makes a measurement one that failed: "wrong by design".
void fail(Json& measurement);
void fail_candidate(Json& record, int coordinates, const std::string& id);

/// Leaves so many samples of every time.
void keep_samples(Json& record, std::size_t repetitions);

/// Erases every candidate with this sparse solver, as of a build without it.
void erase_family(Json& record, const std::string& family);

/// Sets duration [s] and step [s] of the recorded motion.
void set_motion(Json& record, double duration, double step = 0.01);

/// Replaces the samples of a truck candidate.
void set_samples(Json& record, int coordinates, const std::string& id, std::vector<double> samples);
/// Sets three samples around `seconds` for every truck candidate of that id, at every size of the
/// paper.
void set_family(Json& json, const std::string& id, double seconds, double spread = 0.01);

Record record_from(const Json& json);

/// Returns the reader's error message for a record, or "accepted".
std::string complaint(const Json& json);

/// A value at a place of a record, or `removed`, and what the reader says of it: a message that
/// begins with ":" is one about this very place.
struct Refusal {
  std::string place;
  Json value;
  std::string message;
};

/// Expects a record to be read, and to be refused with each of the changes.
void expect_refusals(const Json& record, const std::vector<Refusal>& refusals);

/// Returns the entry in the row whose first texts are `labels`, in the column of that name.
Entry entry_at(const Table& table, const std::vector<std::string>& labels,
               const std::string& column);

/// Expects entries of that row: columns and what they show; " …" stands for a rest that does not
/// matter.
void expect_row(const Table& table, const std::vector<std::string>& labels,
                const std::vector<std::pair<std::string, std::string>>& entries);

const Table& table_named(const Document& document, const std::string& name);

/// Returns a table of a record's report.
Table table_of(const Json& record, const std::string& name);

}  // namespace desmo::report
