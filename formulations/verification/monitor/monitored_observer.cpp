#include "formulations/verification/monitor/monitored_observer.h"

#include <algorithm>
#include <cmath>

namespace desmo {

Flow MonitoredObserver::observe(const Instant& instant) noexcept {
  const Watch::Judgement j = watch_.judge(instant);
  summary_.time = instant.time;
  if (j.assessment.singular) {
    // What was interpolated is nowhere near a solution.
    summary_.status = instant.interpolated ? Status::not_converged : Status::singular;
    summary_.group = j.assessment.group;
    summary_.constraint = -1;
    summary_.residual = instant.interpolated ? INFINITY : instant.residual;
    return Flow::stop;
  }
  if (j.crossing && !summary_.crossing) summary_.crossing = j.crossing;
  summary_.refused = options_.strict && (j.degraded || j.crossing);
  if (summary_.refused) return Flow::stop;
  summary_.updates += instant.updates;
  summary_.residual = max_residual_ = std::max(max_residual_, instant.residual);
  if (options_.judged) options_.judged(j);
  const Flow flow = output_.hand_over(j.instant, next_);
  ++summary_.instants;
  summary_.stopped = flow == Flow::stop;
  return flow;
}

}  // namespace desmo
