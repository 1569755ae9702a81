// desmo_extremes: what every formulation does where most go wrong.
#include <CLI/CLI.hpp>
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
#include "bench/kit/kept_memory.h"
#include "bench/kit/recording.h"
#include "cases/cases.h"
#include "formulations/algebra/blas.h"

namespace desmo::extreme {

namespace {

struct Options {
  std::string record, command, formulations, cases;
  std::vector<std::string> without;
  std::vector<int> rows;
  bool brief = false;
};

std::vector<const Extreme*> chosen_rows(const std::vector<int>& numbers) {
  std::vector<const Extreme*> rows;
  for (const int number : numbers) rows.push_back(&find_extreme(number));
  if (numbers.empty())
    for (const Extreme& row : extremes()) rows.push_back(&row);
  return rows;
}

unsigned left_out(const std::vector<std::string>& names) {
  unsigned monitors = 0;
  for (const std::string& name : names)
    monitors |=
        static_cast<unsigned>(std::ranges::find(monitor_names, name, &MonitorName::name)->monitor);
  return monitors;
}

/// Whether no formulation gave wrong numbers without a flag.
bool run(const Options& options) {
  suite::keep_freed_memory();
  set_blas_threads(1);
  const std::vector<const Extreme*> rows = chosen_rows(options.rows);
  Selection selection{.extent = options.brief ? Extent::brief : Extent::full,
                      .formulations = std::regex(options.formulations),
                      .cases = std::regex(options.cases),
                      .without = left_out(options.without)};
  suite::Recording recording(options.record, options.command);
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
  if (lists["results"].empty())
    throw std::invalid_argument("nothing matches --formulation and --case");
  recording.write(time_grid(30, 0.01), lists);
  return defects == 0;
}

}  // namespace

}  // namespace desmo::extreme

int main(int argc, char** argv) {
  using namespace desmo::extreme;
  CLI::App program{"Every formulation in the table of extremes", "desmo_extremes"};
  Options options;
  program.add_option("--record", options.record, "Write the results record to this file")
      ->required();
  program.add_option("--row", options.rows, "Only these rows of the table, not all");
  program.add_option("--formulation", options.formulations,
                     "Only where this regular expression is found in the formulation's id");
  program.add_option("--case", options.cases,
                     "Only where this regular expression is found in the name of the case");
  std::vector<std::string> names;
  for (const auto& [monitor, name] : desmo::monitor_names) names.emplace_back(name);
  program.add_option("--without", options.without, "Leave this monitor out, to see what it finds")
      ->check(CLI::IsMember(names));
  program.add_flag("--short", options.brief, "What takes seconds, not minutes");
  options.command = desmo::suite::command_line(argc, argv);
  return desmo::suite::record_main(program, argc, argv, [&] { return run(options); });
}
