// The synthetic records of tests/report/data and what tests do to them.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/read/record.h"
#include "report/text/document.h"

namespace desmo::report {

using Json = nlohmann::ordered_json;

inline constexpr const char* truck = "truck_suspension";

std::filesystem::path data_file(const std::string& name);
std::string read_text(const std::filesystem::path& file);

/// data/complete.json: every family, size and status "ok". Made-up numbers.
Json complete_record();

/// The record with timing windows: the least repetition of everything timed is cut into as many,
/// each longer than the last.
Json with_windows(Json record, int windows = 25);

/// The same, with samples of the windows: of as many analyses as there are samples of the whole,
/// and of work that grows with the updates.
Json with_samples_of_windows(Json record, int windows = 25);

/// data/structured.json: small, with structure and requests. Made-up numbers.
Json structured_record();

/// A candidate of such a record. Fails the test when there is none.
Json& candidate_of(Json& record, const std::string& case_name, int coordinates,
                   const std::string& id);
void erase_candidate(Json& record, const std::string& case_name, int coordinates,
                     const std::string& id);
void fail_candidate(Json& record, const std::string& case_name, int coordinates,
                    const std::string& id);

/// Erases every candidate with this sparse solver, as of a build without it.
void erase_family(Json& record, const std::string& family);

/// Makes it a record of so many seconds of motion, in steps of so many seconds.
void set_motion(Json& record, double duration, double step = 0.01);

/// Replaces the samples of a truck candidate.
void set_samples(Json& record, int coordinates, const std::string& id, std::vector<double> samples);
/// Three samples around `seconds` for every truck candidate of that id, at every size of the paper.
void set_family(Json& json, const std::string& id, double seconds, double spread = 0.01);

Record record_from(const Json& json);

/// What the reader complains of, or "accepted".
std::string complaint(const std::string& text);
std::string complaint(const Json& json);

/// The row whose first texts are `labels`, in the column of that name.
Entry entry_at(const Table& table, const std::vector<std::string>& labels,
               const std::string& column);

const Table& table_named(const Document& document, const std::string& name);

}  // namespace desmo::report
