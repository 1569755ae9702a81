#include "formulations/lane_motion.h"

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <utility>

#include "formulations/equations/elementary.h"

namespace desmo {

namespace {

namespace simd = std::experimental;
/// What registers of 256 bits hold.
using Quad = simd::simd<double, simd::simd_abi::deduce_t<double, 4>>;

const std::vector<HarmonicSum::Term>& terms_of(const Motion& motion) {
  return std::get<HarmonicSum>(motion).terms;
}

Quad load(const std::array<double, 4>& x) { return Quad(x.data(), simd::element_aligned); }

[[gnu::always_inline]] inline elementary::SineCosine<Quad> sine_cosine(const Quad& angle) {
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

MotionSampler::MotionSampler(std::vector<const Motion*> motions, std::vector<int> places)
    : motions_(std::move(motions)), places_(std::move(places)) {
  std::vector<int> harmonic;
  for (int i = 0; i < static_cast<int>(motions_.size()); ++i)
    (std::holds_alternative<HarmonicSum>(*motions_[i]) ? harmonic : others_).push_back(i);
  // Those of as many terms beside each other.
  std::ranges::stable_sort(harmonic, {}, [&](int i) { return terms_of(*motions_[i]).size(); });
  for (std::span<const int> left = harmonic; !left.empty();) {
    const std::size_t taken = std::min(left.size(), Quad::size());
    sums_.push_back(sums(left.first(taken)));
    left = left.subspan(taken);
  }
}

MotionSampler::Sums MotionSampler::sums(std::span<const int> motions) const {
  Sums result;
  result.size = static_cast<int>(motions.size());
  for (std::size_t l = 0; l < motions.size(); ++l) {
    result.place[l] = places_[motions[l]];
    result.mean[l] = std::get<HarmonicSum>(*motions_[motions[l]]).mean;
    const std::vector<HarmonicSum::Term>& terms = terms_of(*motions_[motions[l]]);
    result.terms.resize(std::max(result.terms.size(), terms.size()));
    for (std::size_t k = 0; k < terms.size(); ++k) {
      result.terms[k].amplitude[l] = terms[k].amplitude;
      result.terms[k].angular_frequency[l] = terms[k].angular_frequency;
      result.terms[k].phase[l] = terms[k].phase;
    }
  }
  return result;
}

void MotionSampler::operator()(double t, double* z, double* zd, double* zdd) const {
  for (const int i : others_) {
    const int place = places_[i];
    const MotionSample<double> one = sample(*motions_[i], t);
    z[place] = one.position;
    zd[place] = one.velocity;
    zdd[place] = one.acceleration;
  }
  for (const Sums& four : sums_) {
    Quad position = load(four.mean), velocity = 0.0, acceleration = 0.0;
    for (const Terms& terms : four.terms) {
      const Quad a = load(terms.amplitude), w = load(terms.angular_frequency);
      const auto [sine, cosine] = sine_cosine(w * t + load(terms.phase));
      position += a * sine;
      velocity += a * w * cosine;
      acceleration -= a * w * w * sine;
    }
    const auto put = [&](const Quad& values, double* to) {
      std::array<double, Quad::size()> each;
      values.copy_to(each.data(), simd::element_aligned);
      for (int l = 0; l < four.size; ++l) to[four.place[l]] = each[l];
    };
    put(position, z);
    put(velocity, zd);
    put(acceleration, zdd);
  }
}

}  // namespace desmo
