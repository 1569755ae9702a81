#include "formulations/verification/run/running_scales.h"

#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Lower limits of scales. Lengths move at least with this × size × the rates of driven angles, and
/// rotations with this × the rates of driven distances / size. Accelerations are at least this ×
/// velocity² / position.
constexpr double min_scale = 0.01;

}  // namespace

RunningScales::RunningScales(const Model& m, const TimeGrid& grid) {
  for (const Entity& e : m.entities)
    if (!e.fixed) moving_.push_back({e.first, e.size, is_length(e.kind)});
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
  const auto grow = [&](std::span<const double> values, double& length, double& rotation) {
    if (values.empty()) return;
    for (const auto& [first, size, is_length] : moving_) {
      double squares = 0;
      for (int i = first; i < first + size; ++i) squares += values[i] * values[i];
      double& largest = is_length ? length : rotation;
      if (squares > largest * largest) largest = std::sqrt(squares);
    }
  };
  grow(instant.qd, seen_.length.velocity, seen_.rotation.velocity);
  grow(instant.qdd, seen_.length.acceleration, seen_.rotation.acceleration);
}

Scales RunningScales::current() const {
  Scales scales = seen_;
  for (PerLevel<double>* of : {&scales.length, &scales.rotation})
    of->acceleration =
        std::max(of->acceleration, min_scale * of->velocity * of->velocity / of->position);
  return scales;
}

}  // namespace desmo
