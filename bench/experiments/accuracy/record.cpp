#include "bench/experiments/accuracy/record.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "bench/kit/record/time_json.h"
#include "formulations/verification/condition.h"

namespace desmo::accuracy {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> level_names{"position", "velocity", "acceleration"};

/// To six digits: more are noise, and a record has thousands of numbers.
double rounded(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return std::strtod(text, nullptr);
}

Json per_level(const PerLevel<double>& values) {
  Json j;
  for (const Level level : levels) j[level_names[static_cast<int>(level)]] = values[level];
  return j;
}

constexpr double max_error = 1e100;  // that a record holds

/// Nothing for an error beyond all measure, or none at all: JSON has no number for it.
Json error_json(const Error& error) {
  Json j = Json::object();
  for (const Level level : levels) {
    const LevelError& e = error[level];
    if (e.compared > 0 && e.max <= max_error && std::isfinite(e.rms))
      j[level_names[static_cast<int>(level)]] = {{"max", rounded(e.max)}, {"rms", rounded(e.rms)}};
  }
  return j;
}

Json place(const Series& series) {
  return {{"case", series.definition->name},
          {"coordinates", series.coordinates},
          {"step_seconds", series.step},
          {"instants", series.instants}};
}

/// The largest over the instants of the reference.
double condition(const Problem& problem) {
  ConditionNumber number(problem.plan.model);
  double largest = 0;
  for (const ReferenceInstant& instant : problem.reference.instants)
    largest = std::max(largest, number(instant.q));
  return largest;
}

}  // namespace

Json floor_json(const Series& series, const Problem& problem) {
  Json j = place(series);
  j["compared"] = problem.reference.instants.size();
  j["reference"] = per_level(problem.reference.floor);
  const double k = condition(problem);
  if (!std::isfinite(k)) return j;  // singular somewhere: nothing can be predicted
  j["condition"] = k;
  j["limit"] = {{"double", per_level(accuracy_limit(k, std::ldexp(1, -53)))},
                {"float", per_level(accuracy_limit(k, std::ldexp(1, -24)))}};
  return j;
}

Json point_json(const Series& series, const Trial& trial) {
  using enum Trial::State;
  Json j = place(series);
  j["id"] = trial.id();
  j["status"] = trial.state == solved           ? "ok"
                : trial.state == not_applicable ? "not_applicable"
                                                : "failed";
  if (trial.state != solved) {
    j["message"] = trial.message;
    return j;
  }
  j["error"] = error_json(trial.error);
  j["violation"] = error_json(trial.violation);
  j["iterations_per_step"] = rounded(trial.iterations_per_step);
  std::vector<double> samples;
  for (const double seconds : trial.seconds_per_step) samples.push_back(rounded(seconds));
  j["time_per_step"] = bench::time_json(samples);
  return j;
}

}  // namespace desmo::accuracy
