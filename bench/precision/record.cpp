#include "bench/precision/record.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "formulations/accuracy/condition.h"

namespace desmo::precision {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<const char*, 3> level_names{"position", "velocity", "acceleration"};

Json per_level(const PerLevel<double>& values) {
  Json j;
  for (const Level level : levels) j[level_names[static_cast<int>(level)]] = values[level];
  return j;
}

/// Nothing for an error that is no number: JSON has none for it.
Json error_json(const Error& error) {
  Json j;
  for (const Level level : levels) {
    const LevelError& e = error[level];
    if (e.compared > 0 && std::isfinite(e.max) && std::isfinite(e.rms))
      j[level_names[static_cast<int>(level)]] = {{"max", e.max}, {"rms", e.rms}};
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
  ConditionNumber number(problem.plan.mechanism);
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
  j["iterations_per_step"] = trial.iterations_per_step;
  j["seconds_per_step"] = trial.seconds_per_step;
  return j;
}

}  // namespace desmo::precision
