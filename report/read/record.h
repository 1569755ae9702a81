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
  double load_before = 0;  ///< load average over the minute before the run; 0: not known
};

struct Build {
  std::string type;
  std::string compiler;
  std::string flags;
  std::optional<std::string> link;  ///< type of linking, such as "dynamic", and flags
};

struct Blas {
  std::string core;
  std::int64_t threads = 0;
};

struct RecordSettings {
  double tolerance = 0;             ///< Settings::tolerance, a limit of ‖Φ‖₂
  std::int64_t max_iterations = 0;  ///< Settings::max_iterations
  std::string guess;
  double step_seconds = 0;      ///< time between two instants [s]
  double duration_seconds = 0;  ///< duration of the motion [s]
  std::int64_t instants = 0;    ///< number of instants of one analysis
  /// Largest differences from the reference, ≤; none: no limit.
  std::optional<LevelNumbers> allowed;
  /// Number of timing windows into which the motion is cut; none: no windows.
  std::optional<std::int64_t> windows;
};

/// The key of a candidate, unique in a record. Ordered by case, size and id.
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

/// Wall-clock time [s] of each phase of a step in an instrumented run. Of several passes it is the
/// one with the median total.
using Profile = std::array<double, phases.size()>;

/// The time of a formulation that solves only what a request asks. `verification` stays empty.
struct MeasuredRequest : Measurement {
  CandidateKey key;           ///< key of the candidate that solves everything by the formulation
  std::string name;           ///< name of the request, unique for a key
  std::string title;          ///< the request in words
  std::string level;          ///< highest level asked: "position", "velocity" or "acceleration"
  std::int64_t unknowns = 0;  ///< number of unknowns solved at every instant
  std::int64_t all_unknowns = 0;  ///< number of unknowns of the whole mechanism
};

/// A peer: another library, or code written by hand, that solves a case at a size. Unique by key.
struct Peer : Measurement {
  CandidateKey key;  ///< key whose id is "peer:<name>"
  std::string name;
  std::string library, library_version;
  std::string method;  ///< how it solves, in a sentence
  std::string guess;   ///< "previous", "quadratic" …, as in ids of formulations
};

/// A record of one machine. An experiment that was not run leaves its members empty.
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
  std::vector<std::pair<std::string, std::string>> provenance;  ///< leaves() of the head
  // paper; candidates by the wall clock stand apart, so that no table mixes the two clocks
  std::map<CandidateKey, Measurement> candidates;       ///< by CPU clock; verified when ok
  std::map<CandidateKey, Measurement> wall_candidates;  ///< by wall clock; verified when ok
  std::map<CandidateKey, Profile> profiles;
  std::vector<MeasuredRequest> requests;  ///< requests by either clock, in the record's order
  std::vector<Peer> peers;                ///< peers, by the CPU clock, in the record's order
  // accuracy
  std::map<SeriesKey, Floor> floors;  ///< one for every series that has points
  std::map<PointKey, Point> points;   ///< time against error
  // size
  std::map<CandidateKey, TimedSize> growth;      ///< time against number of coordinates
  std::map<CandidateKey, TimedSize> break_even;  ///< time of dense and sparse solvers
  // modelling
  std::map<CandidateKey, ModelledTime> modelled;  ///< ids name the kind of coordinates
  // instructions
  std::map<CandidateKey, StepCount> instructions;
  // extremes
  std::vector<ExtremeRow> extreme_rows;  ///< rows, with the row of every result among them
  std::vector<ExtremeResult> extremes;   ///< results, in the record's order
};

/// A candidate, request or peer with its key. It refers to the record.
using NamedMeasurement = std::pair<CandidateKey, const Measurement*>;

/// Returns all measurements of the paper's experiment: candidates by the CPU clock and by the wall
/// clock, then requests, then peers. The id of a request ends in "/request:<name>".
std::vector<NamedMeasurement> measurements(const Record& record);

/// Returns the end "/request:<name>" of an id; empty where the id is of no request.
inline std::string_view request_of(std::string_view id) {
  return id.substr(std::min(id.find("/request:"), id.size()));
}

/// Tells whether a record has measurements of the paper's experiment.
inline bool has_paper(const Record& record) {
  return !record.candidates.empty() || !record.requests.empty() || !record.peers.empty() ||
         !record.wall_candidates.empty();
}

/// Parses a record and checks all that the report relies on:
/// - the schema's name and major version, required keys, types, nothing given twice
/// - times above zero, as many windows as the settings say
/// - a verification of every "ok" candidate, request, peer and size
/// - one machine, and for each case and size one model and one set of results
/// What exceeds `record.settings.allowed` becomes a failure that says so and has no time. Unknown
/// keys are ignored, so that a record with a newer minor version is read. Throws InputError, or
/// MixedRecord.
Record parse_record(std::string_view text, const std::string& file = "record");

/// Reads a record from a parsed document, of which it may be a part. Throws as parse_record().
Record read_record(const RecordValue& root);

/// Reads a file, plain or gzip, and parses it. Throws as parse_record(), or UnreadableFile.
Record read_record(const std::filesystem::path& file);

/// Reads every file of a folder that has ".json" in its name, as a record. The key is the name up
/// to there. Throws as read_record(), UnreadableFile where the folder cannot be read, and
/// InputError where two files have the same key.
std::map<std::string, Record> read_records(const std::filesystem::path& folder);

}  // namespace desmo::report
