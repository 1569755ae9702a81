// desmo_bench extremes: what every formulation does where most go wrong.
#include <algorithm>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/extremes/record.h"
#include "bench/experiments/extremes/summary.h"
#include "bench/experiments/extremes/table.h"
#include "bench/kit/common_options.h"
#include "bench/kit/memory/kept_memory.h"
#include "bench/kit/record/recording.h"
#include "cases/generators/cases.h"
#include "formulations/algebra/blas.h"

namespace desmo::extremes {

namespace {

struct Options : bench::CommonOptions {
  std::string cases;
  std::vector<std::string> without;
  std::vector<int> rows;
};

std::vector<const Extreme*> chosen_rows(const std::vector<int>& numbers) {
  std::vector<const Extreme*> rows;
  for (const int number : numbers) rows.push_back(&find_extreme(number));
  if (numbers.empty())
    for (const Extreme& row : all_extremes()) rows.push_back(&row);
  return rows;
}

/// Throws std::invalid_argument, naming a monitor that does not exist.
unsigned left_out(const std::vector<std::string>& names) {
  unsigned monitors = 0;
  for (const std::string& name : names) {
    const auto it = std::ranges::find(monitor_names, name, &MonitorName::name);
    if (it == std::ranges::end(monitor_names))
      throw std::invalid_argument("--without: there is no monitor '" + name + "'");
    monitors |= static_cast<unsigned>(it->monitor);
  }
  return monitors;
}

std::string all_monitors() {
  std::string names;
  for (const auto& [monitor, name] : monitor_names)
    names += (names.empty() ? "" : ", ") + std::string(name);
  return names;
}

/// Whether no formulation gave wrong numbers without a flag.
bool measure(const Options& options, const std::string& command) {
  const std::vector<const Extreme*> rows = chosen_rows(options.rows);
  Selection selection{.extent = options.quick ? Extent::brief : Extent::full,
                      .formulations = std::regex(options.filter),
                      .cases = std::regex(options.cases),
                      .without = left_out(options.without)};
  bench::Recording recording(options.record, command);
  nlohmann::ordered_json lists = {{"rows", nlohmann::ordered_json::array()},
                                  {"results", nlohmann::ordered_json::array()}};
  std::size_t defects = 0;
  for (const Extreme* row : rows) {
    selection.say = [&](const std::string& name) {
      std::cerr << "row " << row->number << ": " << name << '\n';
    };
    const std::vector<Result> results = row_results(*row, selection);
    lists["rows"].push_back(row_json(*row));
    for (const Result& result : results) lists["results"].push_back(result_json(result));
    std::cout << summary(*row, results) << std::flush;
    defects += count(results, Verdict::defect);
  }
  if (lists["results"].empty()) throw std::invalid_argument("nothing matches --filter and --case");
  recording.write(time_grid(30, 0.01), lists);
  return defects == 0;
}

int run(const bench::CommandLine& line) {
  Options options;
  bench::OptionTable table("desmo_bench extremes: every formulation in the table of extremes");
  bench::add_common(table, options,
                    {.quick = "what takes seconds, not minutes",
                     .filtered = "the formulation's id",
                     .repetitions = {}});
  table.positives("--row", "N", options.rows,
                  "Only this row of the table; more than once where wanted");
  table.text("--case", "REGEX", options.cases,
             "Only where this regular expression is found in\nthe name of the case");
  table.texts("--without", "MONITOR", options.without,
              "Leave a monitor out, to see what it finds:\n" + all_monitors());
  if (!bench::read_options(table, line)) return 0;
  bench::keep_freed_memory();
  set_blas_threads(1);
  return measure(options, line.text) ? 0 : 1;
}

}  // namespace

}  // namespace desmo::extremes

int desmo::bench::run_extremes(const CommandLine& line) { return desmo::extremes::run(line); }
