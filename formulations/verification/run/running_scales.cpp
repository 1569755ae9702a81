#include "formulations/verification/run/running_scales.h"

#include <algorithm>
#include <cmath>

#include "formulations/verification/run/relative_radius.h"

namespace desmo {

namespace {

/// Lower limits of scales. Lengths move at least with this × size × the rates of driven angles, and
/// rotations with this × the rates of driven distances / size. Accelerations are at least this ×
/// velocity² / position.
constexpr double min_scale = 0.01;

}  // namespace

RunningScales::RunningScales(const Model& m, const TimeGrid& grid) : m_(m) {
  const double size = nominal_size(m);
  PerLevel<double> length, rotation;  // largest rates of drivers
  for (const Driver& d : m.drivers)
    for (int i = 0; i < grid.instants; ++i) {
      const MotionSample<double> z = sample(d.motion, grid.time(i));
      // A rate that is not finite is no scale: the sample is left out.
      if (!std::isfinite(z.velocity) || !std::isfinite(z.acceleration)) continue;
      PerLevel<double>& most = is_length(m.entities[d.coordinate].kind) ? length : rotation;
      most.velocity = std::max(most.velocity, std::abs(z.velocity));
      most.acceleration = std::max(most.acceleration, std::abs(z.acceleration));
    }
  seen_.length = {size, std::max(length.velocity, min_scale * size * rotation.velocity),
                  std::max(length.acceleration, min_scale * size * rotation.acceleration)};
  seen_.rotation = {1, std::max(rotation.velocity, min_scale * length.velocity / size),
                    std::max(rotation.acceleration, min_scale * length.acceleration / size)};
}

void RunningScales::take(const Instant& instant) {
  const PerLevel<std::span<const double>> values{instant.q, instant.qd, instant.qdd};
  for (const Level level : rate_levels) {
    if (values[level].empty()) continue;
    const auto [rotation, length] = max_norms(m_, values[level]);
    seen_.rotation[level] = std::max(seen_.rotation[level], rotation.norm);
    seen_.length[level] = std::max(seen_.length[level], length.norm);
  }
}

Scales RunningScales::current() const {
  Scales scales = seen_;
  for (PerLevel<double>* of : {&scales.length, &scales.rotation})
    of->acceleration =
        std::max(of->acceleration, min_scale * of->velocity * of->velocity / of->position);
  return scales;
}

}  // namespace desmo
