// The part of a record about all experiments but the paper's: plain data.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/read/configuration.h"
#include "report/read/timed.h"

namespace desmo::report {

// ---- accuracy: time against error ----

/// Key of a series: a motion that configurations were tried on. Ordered by case, size, step and
/// instants.
struct SeriesKey : CaseSize {
  double step_seconds = 0;    ///< time between two instants [s]
  std::int64_t instants = 0;  ///< number of instants
  auto operator<=>(const SeriesKey&) const = default;
};

/// Relative errors of a series that no result is expected to fall below.
struct Floor {
  LevelNumbers reference;  ///< differences of the reference's two solutions
  /// Errors that the condition number explains in double and in float; none where a position is
  /// singular.
  std::optional<LevelNumbers> in_double = {}, in_float = {};
};

/// The largest relative errors of a motion. A level is empty where the error is not finite or too
/// large for a record.
using MaxErrors = PerLevel<std::optional<double>>;

/// Key of a point: a series and a configuration's id.
struct PointKey {
  SeriesKey series;
  std::string id;
  auto operator<=>(const PointKey&) const = default;
};

/// A point of time against error: the time of a step of a configuration, and its errors. Its status
/// is ok, failed or not applicable.
struct Point : Measurement {
  Configuration configuration;
  MaxErrors error;  ///< errors when ok; that of position is then known
};

// ---- size: time against size ----

/// The time of a step of a formulation at one size of a case: ok, with verification, or failed.
struct TimedSize : Measurement {
  std::int64_t unknowns = 0;    ///< number of coordinates found at every instant
  double tolerance = 0;         ///< Settings::tolerance
  std::string checked_against;  ///< precision of the reference: "quadruple" or "double"; when ok
  double state_bytes = 0;       ///< size of q, q' and q'' [bytes]; when ok
  std::optional<double> bytes;  ///< memory that the formulation keeps [bytes]; none: not known
};

// ---- modelling: the same in other coordinates ----

/// The time of a step of a formulation in some kind of coordinates. Its `unknowns` are those of the
/// linear systems.
struct ModelledTime : TimedSize {
  /// Number of matrix entries after condensation, and of multiplications and additions that the
  /// condensation takes; none where generated code solves.
  std::optional<std::int64_t> entries = {}, condensation = {};
  double condition = 0;  ///< condition number of the model's equations at the first instant
};

// ---- instructions ----

/// Instructions of a step, with as many Newton iterations as it takes.
struct StepCount {
  std::int64_t instructions = 0;  ///< mean number of instructions of a step
  std::int64_t steps = 0;         ///< number of steps that were counted
  std::string tool;               ///< counting program, and versions that counts depend on
};

// ---- extremes ----

/// A row of the table of extremes.
struct ExtremeRow {
  std::int64_t number = 0;
  std::string name;  ///< short name
  std::string extreme,
      expected;  ///< the difficulty, and the answer that every formulation should give
};

/// The worst relative error of a level, with the error that conditioning explains, the floor.
struct ExtremeError {
  double error = 0, floor = 0;
};

/// The result of a case of a row in one formulation.
struct ExtremeResult {
  enum class Verdict {
    as_expected,
    missed,  ///< less than expected, but no wrong number without a flag
    defect,  ///< wrong numbers, or numbers where there is no answer, without a flag
    not_applicable,
  };
  std::int64_t row = 0;   ///< ExtremeRow::number
  std::string case_name;  ///< unique within the row
  std::string id;         ///< id of a formulation with settings
  Verdict verdict = Verdict::as_expected;
  std::string reason;  ///< reason of any other verdict than as_expected
  std::optional<PerLevel<ExtremeError>> worst = {};  ///< none: nothing was compared
};

}  // namespace desmo::report
