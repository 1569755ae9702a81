#pragma once

#include <cmath>
#include <variant>

namespace desmo {

/// z(t) = start + rate t.
struct ConstantRate {
  double start = 0;  ///< z(0), unit of the coordinate
  double rate = 0;   ///< ż, unit of the coordinate per second
};

/// z(t) = mean + amplitude sin(angular_frequency t + phase).
struct Harmonic {
  double mean = 0;               ///< unit of the coordinate
  double amplitude = 0;          ///< unit of the coordinate
  double angular_frequency = 0;  ///< rad/s
  double phase = 0;              ///< rad
};

/// The prescribed motion of one independent coordinate.
using Motion = std::variant<ConstantRate, Harmonic>;

/// z, ż and z̈ at one instant.
template <class S>
struct MotionSample {
  S position, velocity, acceleration;
};

template <class S>
MotionSample<S> sample(const ConstantRate& m, const S& t) {
  return {S(m.start) + S(m.rate) * t, S(m.rate), S(0)};
}

template <class S>
MotionSample<S> sample(const Harmonic& m, const S& t) {
  using std::cos;
  using std::sin;
  const S w(m.angular_frequency), a(m.amplitude);
  const S angle = w * t + S(m.phase);
  const S sine = sin(angle);
  return {S(m.mean) + a * sine, a * w * cos(angle), -(a * w * w * sine)};
}

/// z(t), ż(t), z̈(t) of a motion, evaluated in the scalar S of t (seconds).
template <class S>
MotionSample<S> sample(const Motion& motion, const S& t) {
  return std::visit([&](const auto& m) { return sample(m, t); }, motion);
}

/// Equally spaced instants. Each is computed from its index, never accumulated.
struct TimeGrid {
  double start = 0;  ///< s
  double step = 0;   ///< s, positive
  int instants = 0;  ///< both ends included

  double time(int i) const { return start + i * step; }
};

}  // namespace desmo
