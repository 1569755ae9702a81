#include "formulations/lane_motion.h"

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
/// What registers of 256 bits hold.
using Quad = simd::simd<double, simd::simd_abi::deduce_t<double, 4>>;

[[gnu::always_inline]] inline elementary::SineCosine<Quad> sine_cosine(const Quad& angle) {
  if (all_of(abs(angle) < elementary::largest_reduced)) return elementary::sine_cosine(angle);
  return {Quad([&](auto l) { return std::sin(angle[l]); }),
          Quad([&](auto l) { return std::cos(angle[l]); })};
}

Quad load(const double* x) { return Quad(x, simd::element_aligned); }
void store(const Quad& value, double* x) { value.copy_to(x, simd::element_aligned); }

/// What has no sines, at several times.
void sample_other(const Motion& motion, std::span<const double> times, double* z, double* zd,
                  double* zdd) {
  std::size_t done = 0;
  if (const auto* const polynomial = std::get_if<Polynomial>(&motion))
    for (; done + Quad::size() <= times.size(); done += Quad::size()) {
      const MotionSample<Quad> four = sample(*polynomial, load(&times[done]));
      store(four.position, z + done);
      store(four.velocity, zd + done);
      store(four.acceleration, zdd + done);
    }
  for (; done < times.size(); ++done) {
    const MotionSample<double> one = sample(motion, times[done]);
    z[done] = one.position;
    zd[done] = one.velocity;
    zdd[done] = one.acceleration;
  }
}

}  // namespace

PlacedMotions driver_motions(const Mechanism& m) {
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

MotionSampler::MotionSampler(PlacedMotions placed, int times)
    : placed_(std::move(placed)), times_(times) {
  using WithFrequencies = std::pair<std::vector<double>, int>;
  std::vector<WithFrequencies> harmonic;
  for (int i = 0; i < static_cast<int>(placed_.motions.size()); ++i)
    if (const auto* const sum = std::get_if<HarmonicSum>(placed_.motions[i])) {
      std::vector<double> frequencies;
      for (const HarmonicSum::Term& term : sum->terms)
        frequencies.push_back(term.angular_frequency);
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
  Sums result{static_cast<int>(motions.size()), {}, {}, {}};
  std::map<double, Term> terms;
  for (std::size_t l = 0; l < Quad::size(); ++l) {
    const int i = motions[std::min(l, motions.size() - 1)];
    const auto& sum = std::get<HarmonicSum>(*placed_.motions[i]);
    result.place[l] = placed_.places[i];
    result.mean[l] = sum.mean;
    for (const auto& [amplitude, w, phase] : sum.terms) {
      Term& term = terms.try_emplace(w, Term{frequency(w)}).first->second;
      term.of_sine[l] += amplitude * std::cos(phase);
      term.of_cosine[l] += amplitude * std::sin(phase);
      term.w_of_sine[l] = w * term.of_sine[l];
      term.w_of_cosine[l] = w * term.of_cosine[l];
      term.w2_of_sine[l] = w * term.w_of_sine[l];  // nothing of nothing, where ω² overflows
      term.w2_of_cosine[l] = w * term.w_of_cosine[l];
    }
  }
  for (const auto& [w, term] : terms) result.terms.push_back(term);
  return result;
}

/// Motions come sorted: one that was met before was met last, but for those of several terms.
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

void MotionSampler::add_up_at_one_time(double* z, double* zd, double* zdd) const {
  for (const Sums& four : sums_) {
    Quad position = load(four.mean.data()), velocity = 0.0, acceleration = 0.0;
    for (const Term& term : four.terms) {
      const double s = sines_[term.frequency], c = cosines_[term.frequency];
      position += load(term.of_sine.data()) * s + load(term.of_cosine.data()) * c;
      velocity += load(term.w_of_sine.data()) * c - load(term.w_of_cosine.data()) * s;
      acceleration -= load(term.w2_of_sine.data()) * s + load(term.w2_of_cosine.data()) * c;
    }
    for (std::size_t l = 0; l < Quad::size(); ++l) {
      const int place = four.place[l];
      z[place] = position[l];
      zd[place] = velocity[l];
      zdd[place] = acceleration[l];
    }
  }
}

void MotionSampler::add_up(double* z, double* zd, double* zdd) const {
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
        const int place = sums.place[m] * times_ + l;
        store(position, z + place);
        store(velocity, zd + place);
        store(acceleration, zdd + place);
      }
}

void MotionSampler::operator()(std::span<const double> times, double* z, double* zd, double* zdd) {
  for (const int i : others_) {
    const int place = placed_.places[i] * times_;
    sample_other(*placed_.motions[i], times, z + place, zd + place, zdd + place);
  }
  find_waves(times);
  times_ == 1 ? add_up_at_one_time(z, zd, zdd) : add_up(z, zd, zdd);
}

}  // namespace desmo
