// Time against error, as a record holds it: plain data.
#pragma once

#include <compare>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "report/read/configuration.h"

namespace desmo::report {

/// A motion that configurations were tried on. Ordered by case, size, step, instants.
struct SeriesKey {
  std::string case_name;
  std::int64_t coordinates = 0;
  double step_seconds = 0;    ///< s, between two instants
  std::int64_t instants = 0;  ///< solved
  auto operator<=>(const SeriesKey&) const = default;
};

/// A number for each level.
struct PerLevel {
  double position = 0, velocity = 0, acceleration = 0;
};

/// What is known of a series beside its points. Relative, as errors are.
struct Floor {
  std::int64_t compared = 0;        ///< instants of the reference
  PerLevel reference;               ///< how far its two solutions differ
  std::optional<double> condition;  ///< κ, the largest; nothing where a position is singular
  std::optional<PerLevel> in_double, in_float;  ///< errors that κ lets be expected; with κ
};

/// Over the outputs and instants compared.
struct LevelError {
  double max = 0, rms = 0;
};

/// Nothing of a level whose error is beyond all measure.
struct Errors {
  std::optional<LevelError> position, velocity, acceleration;
};

struct PointKey {
  SeriesKey series;
  std::string id;
  auto operator<=>(const PointKey&) const = default;
};

/// One configuration tried.
struct Point {
  enum class Status { ok, failed, not_applicable };

  Configuration configuration;
  Status status = Status::failed;
  std::string message;  ///< why it failed or is not applicable
  Errors error;         ///< relative; of position always when ok
  Errors violation;     ///< of the equations
  double iterations_per_step = 0;
  std::vector<double> seconds_per_step;  ///< samples of CPU time; never empty when ok, else always
};

}  // namespace desmo::report
