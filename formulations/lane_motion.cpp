#include "formulations/lane_motion.h"

#include <experimental/simd>

#include "formulations/equations/elementary.h"

namespace desmo {

namespace {

namespace simd = std::experimental;
/// What registers of 256 bits hold.
using Quad = simd::simd<double, simd::simd_abi::deduce_t<double, 4>>;

bool is_reduced(const Quad& angle) { return all_of(abs(angle) < elementary::largest_reduced); }

/// As the template for one time, whose sine and cosine are calls.
bool sample_quad(const HarmonicSum& m, const Quad& t, MotionSample<Quad>& z) {
  z = {m.mean, 0.0, 0.0};
  for (const HarmonicSum::Term& term : m.terms) {
    const double w = term.angular_frequency, a = term.amplitude;
    const Quad angle = w * t + term.phase;
    if (!is_reduced(angle)) return false;
    const auto [sine, cosine] = elementary::sine_cosine(angle);
    z.position += a * sine;
    z.velocity += a * w * cosine;
    z.acceleration -= a * w * w * sine;
  }
  return true;
}

bool sample_quad(const Polynomial& m, const Quad& t, MotionSample<Quad>& z) {
  z = sample(m, t);
  return true;
}

/// Each time may be in another interval.
bool sample_quad(const Spline&, const Quad&, MotionSample<Quad>&) { return false; }

}  // namespace

void sample_lanes(const Motion& motion, std::span<const double> times, double* position,
                  double* velocity, double* acceleration) {
  for (std::size_t first = 0; first < times.size(); first += Quad::size()) {
    const Quad t(&times[first], simd::element_aligned);
    MotionSample<Quad> z{0.0, 0.0, 0.0};
    const bool done = std::visit([&](const auto& m) { return sample_quad(m, t, z); }, motion);
    z.position.copy_to(position + first, simd::element_aligned);
    z.velocity.copy_to(velocity + first, simd::element_aligned);
    z.acceleration.copy_to(acceleration + first, simd::element_aligned);
    for (std::size_t l = first; !done && l < first + Quad::size(); ++l) {
      const MotionSample<double> one = sample(motion, times[l]);
      position[l] = one.position;
      velocity[l] = one.velocity;
      acceleration[l] = one.acceleration;
    }
  }
}

}  // namespace desmo
