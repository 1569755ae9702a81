#include "formulations/motion/prediction/motion_sampler.h"

#include <algorithm>
#include <cmath>
#include <experimental/simd>
#include <map>
#include <numeric>
#include <utility>

#include "formulations/equations/elementary.h"

namespace desmo {

namespace {

namespace simd = std::experimental;
/// Four doubles, as in a register of 256 bits.
using Quad = simd::simd<double, simd::simd_abi::deduce_t<double, 4>>;

[[gnu::always_inline]] inline elementary::SineCosine<Quad> sine_cosine(const Quad& angle) {
  if (all_of(abs(angle) < elementary::max_reduced)) return elementary::sine_cosine(angle);
  return {Quad([&](auto l) { return std::sin(angle[l]); }),
          Quad([&](auto l) { return std::cos(angle[l]); })};
}

Quad load(const double* x) { return Quad(x, simd::element_aligned); }
void store(const Quad& value, double* x) { value.copy_to(x, simd::element_aligned); }

}  // namespace

PlacedMotions driver_motions(const Model& m) {
  PlacedMotions result;
  for (const Driver& d : m.drivers) {
    result.motions.push_back(&d.motion);
    result.places.push_back(m.entities[d.coordinate].first);
  }
  return result;
}

PlacedMotions in_order(std::vector<const Motion*> motions) {
  std::vector<int> places(motions.size());
  std::iota(places.begin(), places.end(), 0);
  return {std::move(motions), std::move(places)};
}

MotionSampler::MotionSampler(PlacedMotions placed, int times, SampleStrides strides)
    : placed_(std::move(placed)), times_(times), strides_(strides) {
  using WithFrequencies = std::pair<std::vector<double>, int>;
  std::vector<WithFrequencies> harmonic;
  for (int i = 0; i < static_cast<int>(placed_.motions.size()); ++i)
    if (const auto* const sum = std::get_if<HarmonicSum>(placed_.motions[i])) {
      std::vector<double> frequencies;
      for (const HarmonicSum::Term& term : sum->terms)
        frequencies.push_back(term.angular_frequency.value);
      std::ranges::sort(frequencies);
      harmonic.emplace_back(std::move(frequencies), i);
    } else {
      others_.push_back(i);
    }
  std::ranges::sort(harmonic);
  std::vector<int> ordered;
  for (const WithFrequencies& motion : harmonic) ordered.push_back(motion.second);
  for (std::span<const int> left = ordered; !left.empty();) {
    const std::size_t taken = std::min(left.size(), Quad::size());
    sums_.push_back(sums(left.first(taken)));
    left = left.subspan(taken);
  }
  while (times_ == 1 && frequencies_.size() % Quad::size() != 0) frequencies_.push_back(0);
  sines_.resize(frequencies_.size() * times_);
  cosines_.resize(frequencies_.size() * times_);
}

MotionSampler::Sums MotionSampler::sums(std::span<const int> motions) {
  Sums result{static_cast<int>(motions.size()), {}, true, {}, {}};
  std::map<double, Term> terms;
  for (std::size_t l = 0; l < Quad::size(); ++l) {
    const int i = motions[std::min(l, motions.size() - 1)];
    const auto& sum = std::get<HarmonicSum>(*placed_.motions[i]);
    result.place[l] = placed_.places[i];
    result.in_order = result.in_order && result.place[l] == result.place[0] + static_cast<int>(l);
    result.mean[l] = sum.mean.value;
    for (const HarmonicSum::Term& of : sum.terms) {
      const double amplitude = of.amplitude.value, w = of.angular_frequency.value,
                   phase = of.phase.value;
      Term& term = terms.try_emplace(w, Term{frequency(w)}).first->second;
      term.of_sine[l] += amplitude * std::cos(phase);
      term.of_cosine[l] += amplitude * std::sin(phase);
      term.w_of_sine[l] = w * term.of_sine[l];
      term.w_of_cosine[l] = w * term.of_cosine[l];
      term.w2_of_sine[l] = w * term.w_of_sine[l];  // 0 stays 0 where ω² overflows
      term.w2_of_cosine[l] = w * term.w_of_cosine[l];
    }
  }
  for (const auto& [w, term] : terms) result.terms.push_back(term);
  return result;
}

/// Returns the index of an angular frequency [rad/s] in frequencies_; adds it where it is new.
/// Motions come sorted by frequencies, so the search begins with the last one.
int MotionSampler::frequency(double w) {
  const auto found = std::find(frequencies_.rbegin(), frequencies_.rend(), w);
  if (found != frequencies_.rend()) return static_cast<int>(frequencies_.rend() - found) - 1;
  frequencies_.push_back(w);
  return static_cast<int>(frequencies_.size()) - 1;
}

void MotionSampler::find_waves(std::span<const double> times) {
  const auto put = [&](const Quad& angle, std::size_t first) {
    const auto [sine, cosine] = sine_cosine(angle);
    store(sine, &sines_[first]);
    store(cosine, &cosines_[first]);
  };
  if (times_ == 1)
    for (std::size_t f = 0; f < frequencies_.size(); f += Quad::size())
      put(load(&frequencies_[f]) * times[0], f);
  else
    for (std::size_t f = 0; f < frequencies_.size(); ++f)
      for (std::size_t l = 0; l < times.size(); l += Quad::size())
        put(frequencies_[f] * load(&times[l]), f * times.size() + l);
}

void MotionSampler::add_up_by_four_motions(double* __restrict z, double* __restrict zd,
                                           double* __restrict zdd) const {
  for (const Sums& four : sums_) {
    for (int l = 0; l < times_; ++l) {
      Quad position = load(four.mean.data()), velocity = 0.0, acceleration = 0.0;
      for (const Term& term : four.terms) {
        const double s = sines_[term.frequency * times_ + l],
                     c = cosines_[term.frequency * times_ + l];
        position += load(term.of_sine.data()) * s + load(term.of_cosine.data()) * c;
        velocity += load(term.w_of_sine.data()) * c - load(term.w_of_cosine.data()) * s;
        acceleration -= load(term.w2_of_sine.data()) * s + load(term.w2_of_cosine.data()) * c;
      }
      const int row = l * strides_.of_time;
      if (four.in_order) {
        store(position, z + row + four.place[0]);
        store(velocity, zd + row + four.place[0]);
        store(acceleration, zdd + row + four.place[0]);
        continue;
      }
      for (std::size_t m = 0; m < Quad::size(); ++m) {
        const int place = row + four.place[m];
        z[place] = position[m];
        zd[place] = velocity[m];
        zdd[place] = acceleration[m];
      }
    }
  }
}

void MotionSampler::add_up_by_four_times(double* z, double* zd, double* zdd) const {
  for (const Sums& sums : sums_)
    for (int m = 0; m < sums.size; ++m)
      for (int l = 0; l < times_; l += static_cast<int>(Quad::size())) {
        Quad position = sums.mean[m], velocity = 0.0, acceleration = 0.0;
        for (const Term& term : sums.terms) {
          const int wave_at = term.frequency * times_ + l;
          const Quad s = load(&sines_[wave_at]), c = load(&cosines_[wave_at]);
          position += term.of_sine[m] * s + term.of_cosine[m] * c;
          velocity += term.w_of_sine[m] * c - term.w_of_cosine[m] * s;
          acceleration -= term.w2_of_sine[m] * s + term.w2_of_cosine[m] * c;
        }
        const int place = sums.place[m] * strides_.of_place + l;
        store(position, z + place);
        store(velocity, zd + place);
        store(acceleration, zdd + place);
      }
}

/// Samples motions that are no harmonic sums.
void MotionSampler::sample_others(std::span<const double> times, double* z, double* zd,
                                  double* zdd) const {
  for (const int i : others_) {
    const Motion& motion = *placed_.motions[i];
    const int place = placed_.places[i] * strides_.of_place;
    std::size_t l = 0;
    const auto* const polynomial = std::get_if<Polynomial>(&motion);
    if (polynomial && strides_.of_time == 1)
      for (; l + Quad::size() <= times.size(); l += Quad::size()) {
        const MotionSample<Quad> four = sample(*polynomial, load(&times[l]));
        store(four.position, z + place + l);
        store(four.velocity, zd + place + l);
        store(four.acceleration, zdd + place + l);
      }
    for (; l < times.size(); ++l) {
      const MotionSample<double> one = sample(motion, times[l]);
      const std::size_t at = place + l * strides_.of_time;
      z[at] = one.position;
      zd[at] = one.velocity;
      zdd[at] = one.acceleration;
    }
  }
}

void MotionSampler::operator()(std::span<const double> times, double* z, double* zd, double* zdd) {
  sample_others(times, z, zd, zdd);
  find_waves(times);
  strides_.of_place == 1 ? add_up_by_four_motions(z, zd, zdd) : add_up_by_four_times(z, zd, zdd);
}

}  // namespace desmo
