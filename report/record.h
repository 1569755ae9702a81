// The record of one run of desmo_bench, as results/record.schema.json defines it: plain data.
#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace desmo::report {

struct Machine {
  std::string cpu;
  std::int64_t cores = 0;
  std::vector<std::string> caches;
  std::string kernel;
  std::string governor;
  std::vector<double> load_before;
  std::vector<double> load_after;
};

struct Build {
  std::string type;
  std::string compiler;
  std::string flags;
};

struct Blas {
  std::string core;
  std::int64_t threads = 0;
};

/// Largest differences from the reference that a verification may find.
struct Allowed {
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
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
};

enum class Status { ok, failed, not_run };

/// Largest absolute differences from the quadruple-precision reference.
struct Verification {
  std::int64_t instants = 0;
  double position = 0;
  double velocity = 0;
  double acceleration = 0;
};

/// What names a cell: unique in a record. Ordered by case, size, id.
struct CellKey {
  std::string case_name;
  std::int64_t coordinates = 0;
  std::string id;
  auto operator<=>(const CellKey&) const = default;
};

struct Cell {
  Status status = Status::not_run;
  std::string message;              ///< why it failed or was not run
  std::vector<double> cpu_seconds;  ///< one per repetition; never empty when ok, always when not
  std::optional<Verification> verification;  ///< always when ok
  std::optional<double> setup_seconds;
  std::optional<double> iterations_per_step;
  std::optional<double> residual;
};

/// Where the wall-clock time of a step went in an instrumented run.
struct Profile {
  /// Phase and wall-clock seconds per step, the median where there were several passes: the
  /// schema's six phases in its order, others by name after them.
  std::vector<std::pair<std::string, double>> seconds_per_step;
  std::optional<std::array<double, 2>> total_range;  ///< s, of all phases: least, largest pass
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
};

}  // namespace desmo::report
