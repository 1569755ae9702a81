#include "formulations/safety/watched_sink.h"

#include <algorithm>

namespace desmo {

void WatchedSink::accept(const Instant& instant) {
  if (instant.interpolated) return hand_on(instant);
  const Watch::Judgement j = watch_.judge(instant);
  summary_.time = instant.time;
  if (j.assessment.singular) {
    summary_.status = Status::singular;
    summary_.group = j.assessment.group;
    summary_.constraint = -1;
    summary_.residual = instant.residual;
    throw Ended{};
  }
  if (j.crossing && !summary_.crossing) summary_.crossing = j.crossing;
  if (j.degraded && summary_.degraded++ == 0)
    summary_.first_degraded = {instant.index, instant.time, j.assessment};
  summary_.refused = options_.strict && (j.degraded || j.crossing);
  if (summary_.refused) throw Ended{};
  summary_.updates += instant.updates;
  summary_.residual = largest_residual_ = std::max(largest_residual_, instant.residual);
  if (options_.judged) options_.judged(j);
  hand_on(j.instant);
}

void WatchedSink::hand_on(const Instant& instant) {
  next_.accept(instant);
  ++summary_.instants;
}

}  // namespace desmo
