#include "formulations/lane_motion.h"

#include <cmath>
#include <experimental/simd>

#include "formulations/equations/elementary.h"

namespace desmo {

namespace {

namespace simd = std::experimental;
/// What registers of 256 bits hold.
using Quad = simd::simd<double, simd::simd_abi::deduce_t<double, 4>>;

Quad load(const std::array<double, 4>& x) { return Quad(x.data(), simd::element_aligned); }

elementary::SineCosine<Quad> sine_cosine(const Quad& angle) {
  if (all_of(abs(angle) < elementary::largest_reduced)) return elementary::sine_cosine(angle);
  return {Quad([&](auto l) { return std::sin(angle[l]); }),
          Quad([&](auto l) { return std::cos(angle[l]); })};
}

/// As the template for one time. False: it cannot be done for four at once.
bool sample_quad(const HarmonicSum& m, const Quad& t, MotionSample<Quad>& z) {
  z = {m.mean, 0.0, 0.0};
  for (const HarmonicSum::Term& term : m.terms) {
    const double w = term.angular_frequency, a = term.amplitude;
    const auto [sine, cosine] = sine_cosine(w * t + term.phase);
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

MotionSampler::MotionSampler(std::vector<const Motion*> motions)
    : motions_(std::move(motions)), samples_(motions_.size()) {
  std::size_t terms = 0;
  for (int i = 0; i < static_cast<int>(motions_.size()); ++i) {
    const auto* const sum = std::get_if<HarmonicSum>(motions_[i]);
    if (!sum) {
      others_.push_back(i);
      continue;
    }
    means_.push_back({i, sum->mean});
    for (const HarmonicSum::Term& term : sum->terms) {
      const std::size_t l = terms++ % Quad::size();
      if (l == 0) terms_.emplace_back();
      Terms& last = terms_.back();
      last.amplitude[l] = term.amplitude;
      last.angular_frequency[l] = term.angular_frequency;
      last.phase[l] = term.phase;
      last.motion[l] = i;
    }
  }
}

std::span<const MotionSample<double>> MotionSampler::operator()(double t) {
  for (const int i : others_) samples_[i] = sample(*motions_[i], t);
  for (const auto& [i, mean] : means_) samples_[i] = {mean, 0.0, 0.0};
  for (const Terms& terms : terms_) {
    const Quad a = load(terms.amplitude), w = load(terms.angular_frequency);
    const auto [sine, cosine] = sine_cosine(w * t + load(terms.phase));
    const Quad z = a * sine, zd = a * w * cosine, zdd = a * w * w * sine;
    for (std::size_t l = 0; l < Quad::size(); ++l) {
      MotionSample<double>& sum = samples_[terms.motion[l]];
      sum.position += z[l];
      sum.velocity += zd[l];
      sum.acceleration -= zdd[l];
    }
  }
  return samples_;
}

}  // namespace desmo
