// The record of a run, as results/record.schema.json defines it: plain data.
#pragma once

#include <algorithm>
#include <array>
#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "report/read/experiments.h"
#include "report/read/timed.h"

namespace desmo::report {

class RecordValue;

struct Machine {
  std::string cpu;
  std::int64_t cores = 0;
  std::vector<std::string> caches;
  std::string governor;
  double load_before = 0;  ///< of the last minute; 0 where it is not known
};

struct Build {
  std::string type;
  std::string compiler;
  std::string flags;
  std::optional<std::string> link;  ///< "dynamic", and its flags
};

struct Blas {
  std::string core;
  std::int64_t threads = 0;
};

struct RecordSettings {
  double tolerance = 0;  ///< of the norm of the constraint equations, whole mechanism
  std::int64_t max_iterations = 0;
  std::string guess;
  double step_seconds = 0;              ///< s, between two instants
  double duration_seconds = 0;          ///< s, of simulated motion
  std::int64_t instants = 0;            ///< solved in one analysis
  std::optional<LevelNumbers> allowed;  ///< largest differences from the reference
  std::optional<std::int64_t> windows;  ///< timing windows into which the motion is cut
};

/// The name of a candidate: unique in a record. Ordered by case, size, id.
struct CandidateKey : CaseSize {
  std::string id;
  auto operator<=>(const CandidateKey&) const = default;
};

/// Returns "<case>/<coordinates>/<id>".
inline std::string name_of(const CandidateKey& key) {
  return key.case_name + "/" + std::to_string(key.coordinates) + "/" + key.id;
}

/// Phases of a step, in the order of a Profile.
inline constexpr std::array phases{"residual", "jacobian",         "factorisation",
                                   "solve",    "right_hand_sides", "rest"};

/// Wall-clock time of each phase of a step in an instrumented run [s], the median of several
/// passes.
using Profile = std::array<double, phases.size()>;

/// A formulation that solves only what is asked; without verification.
struct MeasuredRequest : Measurement {
  CandidateKey key;   ///< the formulation, and the candidate that solves everything with it
  std::string name;   ///< unique for a candidate
  std::string title;  ///< the request in words
  std::string level;  ///< "position", "velocity", "acceleration"
  std::int64_t unknowns = 0;
  std::int64_t all_unknowns = 0;  ///< of the whole mechanism
};

/// Another library, or code written by hand, that solves a case at a size; with its name each once.
struct Peer : Measurement {
  CandidateKey key;  ///< its id is "peer:<name>"
  std::string name;
  std::string library, library_version;
  std::string method;  ///< how it is used, in a sentence
  std::string guess;   ///< "previous", "quadratic": as in the ids of ours
};

struct Record {
  std::string version;
  std::string date;  ///< UTC, ISO 8601
  std::string commit;
  bool dirty = false;
  Machine machine;
  Build build;
  std::map<std::string, std::string> libraries;
  Blas blas;
  RecordSettings settings;
  std::vector<std::pair<std::string, std::string>> provenance;  ///< all of the head, as text
  // paper; what the wall clock measured stands apart, so that no table mixes the two clocks
  std::map<CandidateKey, Measurement> candidates;  ///< CPU clock; verified when ok
  std::map<CandidateKey, Measurement> wall_candidates;
  std::map<CandidateKey, Profile> profiles;
  std::vector<MeasuredRequest> requests;  ///< CPU clock, others are left out; in the record's order
  std::vector<Peer> peers;                ///< CPU clock; in the record's order
  // accuracy
  std::map<SeriesKey, Floor> floors;  ///< one for every series that has points
  std::map<PointKey, Point> points;   ///< time against error
  // size
  std::map<CandidateKey, TimedSize> growth;      ///< time against coordinates
  std::map<CandidateKey, TimedSize> break_even;  ///< dense and sparse, by unknowns
  // modelling
  std::map<CandidateKey, ModelledTime> modelled;  ///< by coordinates
  // instructions
  std::map<CandidateKey, StepCount> instructions;
  // extremes
  std::vector<ExtremeRow> extreme_rows;  ///< the row of every result is among them
  std::vector<ExtremeResult> extremes;   ///< in the record's order
};

/// A candidate, request or peer with its key; it stands in the record.
using NamedMeasurement = std::pair<CandidateKey, const Measurement*>;

/// Returns all of the paper's experiment: candidates by the CPU clock and by the wall clock, then
/// requests, then peers. The id of a request ends in "/request:<name>", a peer's is "peer:<name>".
std::vector<NamedMeasurement> measurements(const Record& record);

/// Returns the end "/request:<name>" of an id; empty where it is of no request.
inline std::string_view request_of(std::string_view id) {
  return id.substr(std::min(id.find("/request:"), id.size()));
}

/// Tells whether it has the paper's experiment.
inline bool has_paper(const Record& record) {
  return !record.candidates.empty() || !record.requests.empty() || !record.peers.empty() ||
         !record.wall_candidates.empty();
}

/// Checks everything the report relies on: the schema's name and major version, required keys,
/// types, times above zero, the verification of every "ok" candidate and request, as many windows
/// as it says, nothing given twice, one machine, one model for each case and size with one set of
/// results. An "ok" candidate or request that exceeds `record.settings.allowed` becomes a failed
/// one that says so and has no time. Unknown keys are ignored, so that a record with a newer minor
/// version is read. Throws InputError, or MixedRecord.
Record parse_record(std::string_view text, const std::string& file = "record");

/// Reads a record that has been parsed already, alone or inside another document.
Record read_record(const RecordValue& root);

/// Reads a file, plain or gzip, and parses it. Throws as parse_record, or UnreadableRecord.
Record read_record(const std::filesystem::path& file);

/// Reads every record of a folder, by the name of its file without endings. Throws as read_record,
/// and UnreadableRecord where there is no folder.
std::map<std::string, Record> read_records(const std::filesystem::path& folder);

}  // namespace desmo::report
