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

/// A motion that configurations were tried on. Ordered by case, size, step, instants.
struct SeriesKey : CaseSize {
  double step_seconds = 0;    ///< s, between two instants
  std::int64_t instants = 0;  ///< solved
  auto operator<=>(const SeriesKey&) const = default;
};

/// Errors below which nothing is to be expected in a series. Relative, as errors are.
struct Floor {
  LevelNumbers reference;  ///< how far its two solutions differ
  /// Errors that conditioning lets be expected; none where a position is singular.
  std::optional<LevelNumbers> in_double = {}, in_float = {};
};

/// The largest errors of a motion. Empty for a level whose error is beyond all measure.
using MaxErrors = PerLevel<std::optional<double>>;

struct PointKey {
  SeriesKey series;
  std::string id;
  auto operator<=>(const PointKey&) const = default;
};

/// A step of a configuration tried: ok, failed or not applicable.
struct Point : Measurement {
  Configuration configuration;
  MaxErrors error;  ///< relative; of position always when ok
};

// ---- size: time against size ----

/// A step of a formulation at one size of a case: ok, then with verification, or failed.
struct TimedSize : Measurement {
  std::int64_t unknowns = 0;
  double tolerance = 0;
  std::string checked_against;  ///< "quadruple", "double": the reference's precision; when ok
  double state_bytes = 0;       ///< q, q', q''
  std::optional<double> bytes;  ///< memory that the formulation keeps
};

// ---- modelling: the same in other coordinates ----

/// A formulation in some coordinates: unknowns are those of its linear systems.
struct ModelledTime : TimedSize {
  /// Entries of the matrices after condensation, and its operations; none where generated code
  /// solves.
  std::optional<std::int64_t> entries = {}, condensation = {};
  double condition = 0;  ///< of the model, at the first instant
};

// ---- instructions ----

/// Instructions of a step, with as many Newton iterations as it takes.
struct StepCount {
  std::int64_t instructions = 0;
  std::int64_t steps = 0;  ///< counted
  std::string tool;        ///< the counting program, and what else counts depend on
};

// ---- extremes ----

struct ExtremeRow {
  std::int64_t number = 0;
  std::string name;  ///< short
  std::string extreme,
      expected;  ///< the difficulty, and the answer that every formulation should give
};

/// The worst error of a level, with the floor that conditioning sets.
struct ExtremeError {
  double error = 0, floor = 0;
};

/// A case of a row in one formulation.
struct ExtremeResult {
  enum class Verdict {
    as_expected,
    missed,  ///< less than expected, and no wrong number without a flag
    defect,  ///< wrong numbers, or numbers where there is no answer, without a flag
    not_applicable,
  };
  std::int64_t row = 0;
  std::string case_name;
  std::string id;  ///< a formulation, with settings
  Verdict verdict = Verdict::as_expected;
  std::string reason;  ///< empty when as expected
  std::optional<PerLevel<ExtremeError>> worst = {};
};

}  // namespace desmo::report
