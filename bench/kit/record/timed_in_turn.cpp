#include "bench/kit/record/timed_in_turn.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "bench/kit/problem.h"
#include "bench/kit/record/record.h"

namespace desmo::bench {

namespace {

constexpr double min_seconds = 0.02;       // least duration of a sample [s]
constexpr double long_motion_seconds = 1;  // a motion that takes longer [s] has two samples

}  // namespace

bool time_in_turn(std::list<FormulationCandidate>& candidates, int repetitions,
                  std::string_view list) {
  for (FormulationCandidate& candidate : candidates) candidate.verify();
  for (int round = 0; round < repetitions; ++round)
    for (FormulationCandidate& candidate : candidates)
      if (!candidate.has_enough_samples(long_motion_seconds)) candidate.sample_afresh(min_seconds);
  bool right = true;
  for (const FormulationCandidate& candidate : candidates) {
    if (candidate.is_timed()) continue;
    right = false;
    std::cerr << list << '/' << candidate.name() << ": " << candidate.message() << '\n';
  }
  return right;
}

nlohmann::ordered_json timed_entry(const FormulationCandidate& candidate) {
  const Problem& problem = candidate.problem();
  const VerifyingRun& found = candidate.verifying_run();
  nlohmann::ordered_json j = {{"case", candidate.case_name()},
                              {"coordinates", candidate.coordinates()},
                              {"id", candidate.id()},
                              {"step_seconds", problem.grid.step},
                              {"instants", problem.grid.instants},
                              {"tolerance", problem.tolerance}};
  j["status"] = candidate.is_timed() ? "ok" : "failed";
  if (!candidate.is_timed()) {
    j["message"] = candidate.message().empty() ? "not timed" : candidate.message();
    return j;
  }
  j["checked_against"] = problem.checked_against;
  j["verification"] = errors_json(found.errors);
  j["iterations_per_step"] = found.iterations_per_step;
  j["residual"] = found.residual.value();
  // The state is q, q̇ and q̈.
  j["state_bytes"] = 3 * sizeof(double) * static_cast<std::size_t>(problem.plan.model.state_size());
  if (found.bytes > 0) j["bytes"] = found.bytes;
  j["time_per_step"] = rounded_time_json(candidate.seconds());
  return j;
}

}  // namespace desmo::bench
