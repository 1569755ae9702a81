// desmo_bench extremes: what every formulation does where most go wrong.
#include <algorithm>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/extremes/table.h"
#include "bench/kit/memory.h"
#include "bench/kit/record/record.h"
#include "cases/generators/cases.h"
#include "formulations/algebra/blas.h"

namespace desmo::extremes {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array outcome_names{"converged", "degraded", "failed", "refused", "not_applicable"};
constexpr std::array verdict_names{"as_expected", "missed", "defect", "not_applicable"};

double rounded(double value) { return bench::rounded(value, 4); }

Json worst_json(const PerLevel<WorstError>& worst) {
  Json j;
  for (const Level level : levels) {
    const WorstError& e = worst[level];
    j[bench::level_names[level]] = {
        {"error", rounded(e.error)}, {"floor", rounded(e.floor)}, {"allowed", rounded(e.allowed)}};
  }
  return j;
}

/// Returns an element of `rows` in the record (results/record.schema.json).
Json row_json(const Extreme& row) {
  return {{"row", row.number},
          {"name", row.name},
          {"extreme", row.extreme},
          {"expected", row.expected}};
}

/// Returns an element of `results` in the record.
Json result_json(const Result& r) {
  const Verification& v = r.verification;
  Json j = {{"row", r.row->number},
            {"case", r.case_name},
            {"id", r.id},
            {"outcome", outcome_names[static_cast<int>(v.outcome)]},
            {"verdict", verdict_names[static_cast<int>(v.verdict)]}};
  if (!v.reason.empty()) j["reason"] = v.reason;
  if (v.instants > 0) {
    j["instants"] = v.instants;
    j["iterations"] = v.iterations;
    j["refactorisations"] = v.refactorisations;
  }
  if (!v.worst) return j;
  j["condition"] = rounded(r.condition);
  j["worst"] = worst_json(*v.worst);
  return j;
}

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

/// Returns whether no formulation gave wrong numbers without a flag.
bool measure(const Options& options, const std::string& command) {
  const std::vector<const Extreme*> rows = chosen_rows(options.rows);
  Selection selection{.extent = options.quick ? Extent::brief : Extent::full,
                      .formulations = std::regex(options.filter),
                      .cases = std::regex(options.cases),
                      .without = left_out(options.without)};
  bench::Recording recording(options.record, command);
  Json lists = {{"rows", Json::array()}, {"results", Json::array()}};
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
  table.add("--row", "N", &options.rows, "Only this row of the table; more than once where wanted");
  table.add("--case", "REGEX", &options.cases,
            "Only where this regular expression is found in\nthe name of the case");
  table.add("--without", "MONITOR", &options.without,
            "Leave a monitor out, to see what it finds:\n" + all_monitors());
  if (!table.read(line)) return 0;
  bench::keep_freed_memory();
  set_blas_threads(1);
  return measure(options, line.text) ? 0 : 1;
}

}  // namespace

}  // namespace desmo::extremes

int desmo::bench::run_extremes(const CommandLine& line) { return desmo::extremes::run(line); }
