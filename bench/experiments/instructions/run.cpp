// desmo_bench instructions: instructions a step, counted by callgrind: repeatable where times are
// not.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/instructions/step_counts.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/process/callgrind.h"
#include "cases/generators/cases.h"

namespace desmo::instructions {

namespace {

constexpr int quick_coordinates = 114;

struct Options : bench::CommonOptions {
  int coordinates = 0;
};

void print(const std::vector<StepCount>& counts) {
  std::printf("%-18s %-68s %12s\n", "case", "formulation", "instructions");
  for (const StepCount& c : counts)
    std::printf("%-18s %-68s %12lld\n", c.case_name.c_str(), c.id.c_str(),
                static_cast<long long>(c.instructions));
  std::printf("\nWhat checks add to a step:\n");
  for (const StepCount& c : counts)
    if (bench::check_of(c.id) != CheckMode::none)
      std::printf(
          "%-18s %-68s %12lld %5.1f %%\n", c.case_name.c_str(), c.id.c_str(),
          static_cast<long long>(c.checks),
          100.0 * static_cast<double>(c.checks) / static_cast<double>(c.instructions - c.checks));
}

nlohmann::ordered_json counts_json(const std::vector<StepCount>& counts, const std::string& tool) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const StepCount& c : counts)
    list.push_back({{"case", c.case_name},
                    {"coordinates", c.coordinates},
                    {"id", c.id},
                    {"instructions_per_step", c.instructions},
                    {"steps", c.steps},
                    {"tool", tool}});
  return {{"counts", std::move(list)}};
}

void measure(const Options& options, const bench::CommandLine& line) {
  const std::regex expression(options.filter);
  const int coordinates = options.quick ? quick_coordinates : 0;
  std::vector<StepCount> counts =
      to_be_counted(options.coordinates > 0 ? options.coordinates : coordinates);
  std::erase_if(counts,
                [&](const StepCount& c) { return !std::regex_search(c.text(), expression); });
  if (counts.empty()) throw std::invalid_argument("nothing matches " + options.filter);
  const std::string tool = bench::counting_tool();
  if (tool.empty()) throw std::runtime_error("valgrind, which counts, cannot be run");
  std::optional<bench::RecordWriter> recording;
  if (!options.record.empty()) recording.emplace(options.record, line.text, line.experiment);
  count(counts, bench::beside_this_program("desmo_steps"));
  print(counts);
  if (recording) recording->write(cases().front().with_units(1).grid, counts_json(counts, tool));
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  Options options;
  CLI::App parser("desmo_bench instructions: instructions a step, counted by callgrind");
  bench::add_common(parser, options,
                    {.quick = std::to_string(quick_coordinates) + " coordinates",
                     .filtered = "<case>/<coordinates>/<id>",
                     .repetitions = {}});
  parser
      .add_option("--coordinates", options.coordinates,
                  "Of both cases (the largest of the paper's sizes)")
      ->type_name("N")
      ->check(bench::refuse_not_positive);
  if (bench::read(parser, line.arguments)) measure(options, line);
  return bench::success;
}

}  // namespace desmo::instructions
