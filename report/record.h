// The record of one run of desmo_bench or of one of its siblings, as results/record.schema.json
// defines it: plain data.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/extremes/results.h"
#include "report/precision/points.h"
#include "report/precision/promises.h"
#include "report/segments.h"
#include "report/sizes/timed_size.h"
#include "report/verification.h"

namespace desmo::report {

struct Machine {
  std::string cpu;
  std::int64_t cores = 0;
  std::vector<std::string> caches;
  std::string kernel;
  std::string governor;
  std::optional<std::string> turbo;  ///< "on", "off", "unknown"; since 1.3.0
  std::vector<double> load_before;
  std::vector<double> load_after;
};

struct Link {
  std::string type;  ///< "dynamic", "static"
  std::string flags;
  std::vector<std::string> libraries;  ///< shared objects loaded
};

struct Build {
  std::string type;
  std::string compiler;
  std::string flags;
  std::optional<Link> link;           ///< since 1.3.0
  std::optional<std::string> binary;  ///< SHA-256 of the program, or "unknown"; since 1.3.0
};

struct Blas {
  std::string core;
  std::int64_t threads = 0;
};

struct Settings {
  double tolerance = 0;  ///< of the norm of the constraint equations, whole mechanism
  std::int64_t max_iterations = 0;
  std::string guess;
  double step_seconds = 0;      ///< s, between two instants
  double duration_seconds = 0;  ///< s, of simulated motion
  std::int64_t instants = 0;    ///< solved in one analysis
  std::string clock;
  std::optional<Allowed> allowed;
  std::optional<std::string> reducer;    ///< of samples to a time; since 1.3.0
  std::optional<std::int64_t> segments;  ///< into which the motion is cut; since 1.4.0
};

/// What a time is of. All since 1.3.0; digests are SHA-256.
struct Origin {
  std::optional<std::string> machine;  ///< CPU that it was measured on
  std::optional<std::string> model;    ///< digest of the mechanism
  std::optional<std::string> results;  ///< digest of the answers, rounded to what is allowed
};

/// What names a cell: unique in a record. Ordered by case, size, id.
struct CellKey {
  std::string case_name;
  std::int64_t coordinates = 0;
  std::string id;
  auto operator<=>(const CellKey&) const = default;
};

/// So many parts that a library solves, of so many unknowns each.
struct Solver {
  std::string algebra;
  std::int64_t parts = 0;
  std::array<std::int64_t, 2> unknowns{};  ///< least, most
};

struct Cell {
  Status status = Status::not_run;
  std::string message;  ///< why it failed or was not run
  Origin origin;
  std::vector<double> cpu_seconds;  ///< one per repetition; never empty when ok, always when not
  Segments segments;  ///< Settings::segments when ok; one where several threads solved it
  std::optional<Verification> verification;  ///< always when ok
  std::optional<double> setup_seconds;
  std::optional<double> iterations_per_step;
  std::optional<double> residual;
  std::vector<Solver> solvers;  ///< where they were chosen by measurement; since 1.10.0
};

/// Where the wall-clock time of a step went in an instrumented run.
struct Profile {
  /// Phase and wall-clock seconds per step, the median where there were several passes: the
  /// schema's six phases in its order, others by name after them.
  std::vector<std::pair<std::string, double>> seconds_per_step;
  std::optional<std::array<double, 2>> total_range;  ///< s, of all phases: least, largest pass
};

/// What names the structure that a partition gives: ordered by case, size, partition.
struct StructureKey {
  std::string case_name;
  std::int64_t coordinates = 0;
  std::string partition;  ///< as in the ids: "global", "group", "block"
  auto operator<=>(const StructureKey&) const = default;
};

/// So many parts with so many unknowns each.
struct PartSizes {
  std::int64_t unknowns = 0;
  std::int64_t count = 0;
};

/// The parts into which a partition cuts the unknowns; constant ones are left out.
struct Structure {
  std::int64_t units = 1;        ///< equal ones of which the case is built
  std::vector<PartSizes> parts;  ///< each number of unknowns once, largest first; never empty
};

/// A formulation that solves only what is asked.
struct Request {
  CellKey cell;       ///< the formulation, and the cell that solves everything with it
  std::string name;   ///< unique for a cell
  std::string title;  ///< what is asked, for people
  std::string level;  ///< "position", "velocity", "acceleration"
  std::int64_t unknowns = 0;
  std::int64_t all_unknowns = 0;  ///< of the whole mechanism
  Status status = Status::not_run;
  std::string message;  ///< why it failed or was not run
  Origin origin;
  std::vector<double> cpu_seconds;   ///< one per repetition; never empty when ok, always when not
  Segments segments;                 ///< Settings::segments when ok
  std::optional<double> difference;  ///< from the whole mechanism's solution; always when ok
  std::optional<double> iterations_per_step;
};

/// A rival that solves a case at a size; with its name each once.
struct Peer {
  std::string case_name;
  std::int64_t coordinates = 0;
  std::string name;
  std::string library, library_version;
  std::string method;  ///< how it is used, in a sentence
  std::string guess;   ///< "previous", "quadratic": as in the ids of ours
  std::string setup;   ///< what had to be set up, in words; may be empty unless ok
  std::optional<std::int64_t> compared;  ///< coordinates that it finds, of those there are
  Cell cell;
};

/// Instructions of a step, with as many Newton iterations as it takes.
struct StepCount {
  std::int64_t instructions = 0;
  std::int64_t steps = 0;  ///< counted
  std::string tool;        ///< what counted, and what else counts depend on
};

struct Record {
  std::string version;
  std::string date;  ///< UTC, ISO 8601
  std::string commit;
  bool dirty = false;
  std::string command;
  Machine machine;
  Build build;
  std::map<std::string, std::string> libraries;
  Blas blas;
  Settings settings;
  std::map<CellKey, Cell> cells;
  std::map<CellKey, Profile> profiles;
  std::map<StructureKey, Structure> structure;  ///< since 1.2.0
  std::vector<Request> requests;                ///< since 1.2.0, in the record's order
  std::vector<Peer> peers;                      ///< since 1.3.0, in the record's order
  std::map<SeriesKey, Floor> floors;            ///< since 1.5.0; of every series with points
  std::map<PointKey, Point> points;             ///< since 1.5.0: time against error
  std::vector<Promise> promises;                ///< since 1.5.0, in the record's order
  std::map<CellKey, TimedSize> growth;          ///< since 1.7.0: time against coordinates
  std::map<CellKey, TimedSize> crossing;        ///< since 1.7.0: dense and sparse, by unknowns
  std::map<CellKey, StepCount> instructions;    ///< since 1.7.0
  std::vector<ExtremeRow> extreme_rows;         ///< since 1.7.0; of every result
  std::vector<ExtremeResult> extremes;          ///< since 1.7.0, in the record's order
};

/// Whether it has what desmo_bench measures: the paper's experiment.
inline bool has_cells(const Record& record) {
  return !record.cells.empty() || !record.requests.empty() || !record.peers.empty();
}

/// Whether it has what desmo_growth measures.
inline bool has_sizes(const Record& record) {
  return !record.growth.empty() || !record.crossing.empty();
}

}  // namespace desmo::report
