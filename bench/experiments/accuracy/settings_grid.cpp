#include "bench/experiments/accuracy/settings_grid.h"

#include <array>
#include <span>

#include "formulations/equations/lane_kernel.h"

namespace desmo::accuracy {

namespace {

constexpr std::array guesses{Guess::previous, Guess::linear,   Guess::quadratic,
                             Guess::hermite3, Guess::hermite5, Guess::adams8};
constexpr std::array strides{2, 4, 8, 16, 32};
constexpr std::array reduced_strides{8, 16, 32};  // they give even closed forms three errors

/// Returns settings that differ in where Newton's method stops: at a tolerance, or after a number
/// of iterations.
std::vector<Settings> stops() {
  std::vector<Settings> all;
  for (const double tolerance : {1e-2, 1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    all.push_back({.tolerance = tolerance});
  for (const int iterations : {1, 2}) all.push_back({.fixed_iterations = iterations});
  return all;
}

void add_strides(std::vector<Settings>& all, Settings settings, std::span<const int> some) {
  for (const int stride : some) {
    settings.stride = stride;
    all.push_back(settings);
  }
}

/// Returns settings with which strides are tried: the paper's, and those that usually cost least
/// with an error below that of interpolation.
std::vector<Settings> solved_from() {
  return {Settings{},
          {.tolerance = 1e-10, .guess = Guess::hermite5},
          {.tolerance = 1e-10, .guess = Guess::hermite5, .jacobian = JacobianUpdate::step}};
}

}  // namespace

std::vector<Settings> minimal_settings() {
  std::vector<Settings> all{Settings{}};
  for (const Guess guess : {Guess::previous, Guess::linear, Guess::quadratic})
    all.push_back({.guess = guess, .fixed_iterations = 1});
  all.push_back({.fixed_iterations = 2});
  return all;
}

std::vector<Settings> reduced_settings() {
  std::vector<Settings> all = minimal_settings();
  all.push_back({.fixed_iterations = 3});
  for (const Guess guess : {Guess::previous, Guess::linear})
    for (const double tolerance : {1e-4, 1e-6, 1e-8})
      all.push_back({.tolerance = tolerance, .guess = guess});
  add_strides(all, {}, reduced_strides);
  return all;
}

std::vector<Settings> full_settings(const Variant& variant) {
  std::vector<Settings> all;
  for (const Guess guess : guesses)
    for (const JacobianUpdate update : {JacobianUpdate::newton, JacobianUpdate::step})
      for (Settings s : stops()) {
        s.guess = guess;
        s.jacobian = update;
        all.push_back(s);
      }
  for (const Settings& s : solved_from()) add_strides(all, s, strides);
  if (!variant.is_explicit()) return all;
  std::vector<Settings> with_lanes = all;
  for (Settings& s : with_lanes) s.lanes = lane_counts.front();
  std::erase_if(with_lanes,
                [&](const Settings& s) { return !unsupported_reason(variant, s).empty(); });
  all.insert(all.end(), with_lanes.begin(), with_lanes.end());
  return all;
}

}  // namespace desmo::accuracy
