#include "bench/regression/rounds.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <random>
#include <utility>

#include "bench/kit/process/progress.h"

namespace desmo::regression {

namespace {

using Random = std::mt19937_64;

constexpr int placements = 256;  // number of places of data, 16 bytes apart: 4096 bytes, a page

/// Starts a side's desmo_probe on a core (-1: any), ready to time candidates.
std::unique_ptr<bench::Child> start(const Side& side, int core) {
  std::vector<std::string> arguments{"time", std::to_string(TimingSettings::instants)};
  if (!side.slowed.empty())
    arguments.insert(arguments.end(), {side.slowed, std::to_string(side.percent)});
  bench::Launch launch = side.probe(std::move(arguments));
  launch.core = core;
  launch.fresh_copy = true;
  return std::make_unique<bench::Child>(launch);
}

/// Returns the least CPU time of a candidate in one turn [s], with its data in a random place.
double ask(bench::Child& probe, const std::string& name, Random& random) {
  probe.say(name + ' ' + std::to_string(TimingSettings::repetitions) + ' ' +
            std::to_string(random() % placements));
  return std::stod(probe.read_answer());
}

}  // namespace

bench::Launch Side::probe(std::vector<std::string> arguments) const {
  arguments.insert(arguments.begin(), folder + "/desmo_probe");
  return bench::fixed_launch(std::move(arguments));
}

Times time_rounds(const std::vector<Side>& sides, std::vector<std::string> names, int count,
                  std::uint64_t seed) {
  Random random(seed);
  const std::vector<int> cores = bench::usable_cores();
  bench::Progress progress("rounds of " + std::to_string(names.size()) + " candidates", count);
  names.push_back(control_name);
  std::vector<std::size_t> order(sides.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;

  Times times;
  for (int round = 0; round < count; ++round) {
    const int core = cores.empty() ? -1 : cores[static_cast<std::size_t>(round) % cores.size()];
    std::vector<std::unique_ptr<bench::Child>> probes;
    for (const Side& side : sides) probes.push_back(start(side, core));
    std::ranges::shuffle(names, random);
    for (const std::string& name : names) {
      std::vector<double> least(sides.size(), std::numeric_limits<double>::infinity());
      for (int turn = 0; turn < TimingSettings::turns; ++turn) {
        std::ranges::shuffle(order, random);
        for (const std::size_t i : order)
          least[i] = std::min(least[i], ask(*probes[i], name, random));
      }
      for (std::size_t i = 0; i < sides.size(); ++i) times[name][sides[i].name].push_back(least[i]);
    }
    progress.add_done();
  }
  return times;
}

}  // namespace desmo::regression
