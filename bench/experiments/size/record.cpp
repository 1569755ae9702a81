#include "bench/experiments/size/record.h"

#include <nlohmann/json.hpp>

#include "bench/kit/record/environment_json.h"
#include "bench/kit/record/record_layout.h"
#include "bench/kit/record/time_json.h"
#include "bench/kit/structure.h"

namespace desmo::size {

nlohmann::ordered_json entry_json(const Series& series, const Problem& problem,
                                  const Contender& contender) {
  const Model& m = problem.model;
  nlohmann::ordered_json j = {
      {"case", series.definition->name},       {"coordinates", m.coordinates()},
      {"unknowns", bench::moving_unknowns(m)}, {"id", contender.id},
      {"step_seconds", problem.grid.step},     {"instants", problem.grid.instants},
      {"tolerance", problem.tolerance}};
  const bool timed = contender.is_right() && !contender.seconds_per_step.empty();
  j["status"] = timed ? "ok" : "failed";
  if (!timed) {
    j["message"] = contender.message.empty() ? "not timed" : contender.message;
    return j;
  }
  j["checked_against"] = problem.checked_against;
  j["verification"] = bench::errors_json(contender.errors);
  j["iterations_per_step"] = contender.iterations_per_step;
  j["residual"] = contender.residual;
  // q, q̇ and q̈
  j["state_bytes"] = 3 * sizeof(double) * static_cast<std::size_t>(m.state_size());
  if (contender.bytes > 0) j["bytes"] = contender.bytes;
  std::vector<double> samples;
  for (const double seconds : contender.seconds_per_step)
    samples.push_back(bench::rounded(seconds));
  j["time_per_step"] = bench::time_json(samples);
  return j;
}

}  // namespace desmo::size
