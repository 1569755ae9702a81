#include "bench/experiments/extremes/starts.h"

#include <cmath>
#include <random>

#include "formulations/scaling/scales.h"

namespace desmo::extremes {

std::vector<std::vector<double>> make_starts(const Model& m, const ExtremeCase::Starts& starts) {
  const std::vector<double> magnitude = natural_magnitudes(m);
  const std::vector<bool> driven = independent_coordinates(m);
  std::mt19937_64 bits(1);
  // Of the standard's distributions every library has its own.
  const auto even = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -52) - 1; };
  std::vector<std::vector<double>> all(starts.count, m.estimate);
  for (std::vector<double>& estimate : all)
    for (int i = 0; i < m.coordinates(); ++i)
      if (!driven[i]) estimate[i] += starts.off * magnitude[i] * even();
  return all;
}

}  // namespace desmo::extremes
