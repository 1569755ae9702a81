#include "bench/experiments/extremes/known_case.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <random>
#include <stdexcept>

namespace desmo::extremes {

namespace {

/// Returns estimates of a mechanism's positions that are off by up to `off` of natural magnitudes,
/// the drivers' excepted: evenly distributed, the same in every run.

std::vector<std::vector<double>> make_starts(const Model& m, const ExtremeCase::Starts& starts) {
  const std::vector<double> magnitude = natural_magnitudes(m);
  const std::vector<bool> driven = independent_coordinates(m);
  std::mt19937_64 bits(1);
  // Every library has distributions of its own.
  const auto even = [&] { return std::ldexp(static_cast<double>(bits() >> 11), -52) - 1; };
  std::vector<std::vector<double>> all(starts.count, m.estimate);
  for (std::vector<double>& estimate : all)
    for (int i = 0; i < m.coordinates(); ++i)
      if (!driven[i]) estimate[i] += starts.off * magnitude[i] * even();
  return all;
}

constexpr int spread_instants = 201;

std::vector<int> compared_instants(const ExtremeCase& c) {
  const int count = c.starts ? c.starts->count : c.scene.grid.instants;
  std::vector<int> all;
  if (const int ends = c.compared_at_ends; ends > 0) {
    for (int i = 0; i < ends; ++i) all.push_back(i);
    for (int i = count - ends; i < count; ++i) all.push_back(i);
    return all;
  }
  const int compared = c.starts ? count : std::min(count, spread_instants);
  for (int i = 0; i < compared; ++i)
    all.push_back(
        compared == 1 ? 0 : static_cast<int>(static_cast<long>(i) * (count - 1) / (compared - 1)));
  return all;
}

}  // namespace

double KnownCase::condition() const {
  double largest = 0;
  for (const Answers& a : answers) largest = std::max(largest, a.condition);
  return largest;
}

KnownCase make_known_case(const ExtremeCase& c) {
  KnownCase p{.definition = &c,
              .modelled = {},
              .refusal = {},
              .no_answer = {},
              .answers = {},
              .compared = compared_instants(c),
              .solvable = {},
              .ends = {},
              .starts = {}};
  p.solvable.assign(c.starts ? c.starts->count : c.scene.grid.instants, true);
  if (c.ends_singular) p.solvable.back() = false;
  try {
    p.modelled = model_mechanism(c.scene.mechanism, c.scene.motions);
  } catch (const std::invalid_argument& error) {
    p.refusal = error.what();
    return p;
  }
  if (c.starts) p.starts = make_starts(p.modelled->model, *c.starts);
  if (c.is_refused) return p;  // there is none
  try {
    for (std::size_t i = 0; i < c.chains.size(); ++i) p.answers.push_back(chain_answers(p, i));
    if (c.chains.empty() && p.modelled->model.coordinates() > 0)
      p.answers.push_back(reference_answers(p));
  } catch (const std::exception& error) {
    p.no_answer = error.what();
    p.answers.clear();
  }
  return p;
}

}  // namespace desmo::extremes
