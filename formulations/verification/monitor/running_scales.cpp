#include "formulations/verification/monitor/running_scales.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

namespace desmo {

namespace {

/// Instants at which drivers are looked at beforehand.
constexpr int looks = 64;
/// What unknowns do at least of what drivers do, before they have been seen.
constexpr double min_scale = 0.01;

/// The largest of drivers at one level, of lengths or of rotations.
struct Largest {
  double velocity = 0, acceleration = 0;

  /// What is no number will end the motion before it.
  void take(double v, double a) {
    if (!std::isfinite(v) || !std::isfinite(a)) return;
    velocity = std::max(velocity, std::abs(v));
    acceleration = std::max(acceleration, std::abs(a));
  }
};

}  // namespace

std::vector<double> looks_ahead(const TimeGrid& grid) {
  std::vector<double> times;
  for (int i = 0; i <= looks; ++i)
    times.push_back(grid.start + i * (grid.step * std::max(0, grid.instants - 1) / looks));
  return times;
}

RunningScales::RunningScales(const Model& m, const TimeGrid& grid,
                             const std::optional<Scales>& given)
    : are_given_(given), is_length_(m.coordinates()) {
  for (const Entity& e : m.entities)
    if (!e.fixed) std::fill_n(is_length_.begin() + e.first, e.size, is_length(e.kind) ? 1.0 : 0.0);
  const double size = nominal_size(m);
  Largest length, rotation;
  for (const Driver& d : m.drivers)
    for (const double t : looks_ahead(grid)) {
      const MotionSample<double> z = sample(d.motion, t);
      (is_length(m.entities[d.coordinate].kind) ? length : rotation)
          .take(z.velocity, z.acceleration);
    }
  seen_.length = {size, std::max(length.velocity, min_scale * size * rotation.velocity),
                  std::max(length.acceleration, min_scale * size * rotation.acceleration)};
  seen_.rotation = {1, std::max(rotation.velocity, min_scale * length.velocity / size),
                    std::max(rotation.acceleration, min_scale * length.acceleration / size)};
  scales_ = given ? *given : completed(seen_);
}

bool RunningScales::take(const Instant& instant) {
  const bool grows = grow(seen_, instant);
  if (grows) scales_ = completed(seen_);
  return grows;
}

Scales RunningScales::with(const Instant& instant) const {
  Scales seen = seen_;
  return grow(seen, instant) ? completed(seen) : scales_;
}

bool RunningScales::grow(Scales& seen, const Instant& instant) const {
  if (are_given_) return false;
  const auto largest = [&](std::span<const double> values, double& length, double& rotation) {
    if (values.empty()) return false;
    const auto n = static_cast<Eigen::Index>(values.size());
    const auto size = Eigen::Map<const Eigen::ArrayXd>(values.data(), n).abs();
    const Eigen::Map<const Eigen::ArrayXd> mask(is_length_.data(), n);
    const double l = (size * mask).maxCoeff(), r = (size * (1 - mask)).maxCoeff();
    const bool grows = l > length || r > rotation;
    length = std::max(length, l);
    rotation = std::max(rotation, r);
    return grows;
  };
  const bool v = largest(instant.qd, seen.length.velocity, seen.rotation.velocity);
  const bool a = largest(instant.qdd, seen.length.acceleration, seen.rotation.acceleration);
  return v || a;
}

/// What does not accelerate is judged by its speed.
Scales RunningScales::completed(Scales seen) {
  for (PerLevel<double>* of : {&seen.length, &seen.rotation})
    of->acceleration =
        std::max(of->acceleration, min_scale * of->velocity * of->velocity / of->position);
  return seen;
}

}  // namespace desmo
