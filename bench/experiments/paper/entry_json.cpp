#include "bench/experiments/paper/entry_json.h"

#include <nlohmann/json.hpp>

#include "bench/kit/record/environment.h"
#include "bench/kit/record/record.h"

namespace desmo::paper {

nlohmann::ordered_json with_measurement(nlohmann::ordered_json j, const bench::Candidate& c) {
  j["status"] = c.is_timed() ? "ok" : c.is_not_run() ? "not_run" : "failed";
  if (!c.is_timed()) j["message"] = c.message().empty() ? "not timed" : c.message();
  if (c.is_not_run()) return j;
  const bench::VerifyingRun& found = c.verifying_run();
  j["machine"] = bench::processor_name();
  if (!found.model.empty()) j["model"] = found.model;
  if (!found.results.empty()) j["results"] = found.results;
  if (!c.is_timed()) return j;
  j["verification"] = bench::errors_json(found.errors, found.level);
  if (c.threads() > 1) j["threads"] = c.threads();
  j["time"] = bench::time_json(c.seconds(), c.clock());
  if (c.clock() == bench::Clock::cpu) j["time"]["windows"] = bench::windows_json(c.windows());
  j["setup_time"] = bench::time_json({found.setup_seconds});
  j["iterations_per_step"] = found.iterations_per_step;
  if (found.residual) j["residual"] = *found.residual;
  return j;
}

}  // namespace desmo::paper
