// desmo_bench extremes: what every formulation does where most go wrong.
#include <CLI/CLI.hpp>
#include <array>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/experiments/experiments.h"
#include "bench/experiments/extremes/table.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/process/progress.h"
#include "cases/mechanism/names.h"
#include "formulations/base/per_level.h"

namespace desmo::extremes {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::array outcome_names{"converged", "degraded", "failed", "refused", "not_applicable"};
constexpr std::array verdict_names{"as_expected", "missed", "defect", "not_applicable"};

double rounded(double value) { return bench::rounded(value, 4); }

Json worst_json(const PerLevel<WorstError>& worst) {
  Json j;
  for (const Level level : all_levels) {
    const WorstError& e = worst[level];
    j[level_names[level]] = {
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
  if (v.worst) j["worst"] = worst_json(*v.worst);
  return j;
}

struct Options : bench::CommonOptions {
  std::string cases;
  std::vector<int> rows;
};

std::vector<const Extreme*> chosen_rows(const std::vector<int>& numbers) {
  std::vector<const Extreme*> rows;
  for (const int number : numbers) rows.push_back(&find_extreme(number));
  if (numbers.empty())
    for (const Extreme& row : all_extremes()) rows.push_back(&row);
  return rows;
}

/// Returns an expression for the ids of the formulations that are tried: --filter; in a quick run
/// without it, bench::checked_ids.
std::regex chosen_formulations(const Options& options) {
  if (!options.quick || !options.filter.empty()) return std::regex(options.filter);
  return std::regex("^(" + joined(bench::checked_ids, std::identity{}, "|") + ")$");
}

/// Measures the rows that are chosen, and writes their record. Returns whether no verdict is
/// ExtremeVerdict::defect.
bool measure(const Options& options, const bench::CommandLine& line) {
  const std::vector<const Extreme*> rows = chosen_rows(options.rows);
  Selection selection{.extent = options.quick ? Extent::brief : Extent::full,
                      .formulations = chosen_formulations(options),
                      .cases = std::regex(options.cases)};
  bench::RecordWriter recording = begin_record(options, line);
  Json lists = {{"rows", Json::array()}, {"results", Json::array()}};
  bool is_right = true;
  bench::Progress progress("rows", static_cast<double>(rows.size()));
  selection.on_case_done = [&](double share) { progress.add_done(share); };
  for (const Extreme* row : rows) {
    const std::vector<Result> results = row_results(*row, selection);
    if (results.empty()) progress.add_done();
    lists["rows"].push_back(row_json(*row));
    for (const Result& result : results) {
      lists["results"].push_back(result_json(result));
      if (result.verification.verdict != ExtremeVerdict::defect) continue;
      is_right = false;
      progress.clear();
      std::cerr << "row " << row->number << ", " << result.case_name << ", " << result.id << ": "
                << result.verification.reason << '\n';
    }
  }
  if (lists["results"].empty()) throw std::invalid_argument("nothing matches --filter and --case");
  recording.write(time_grid(30, 0.01), lists);
  return is_right;
}

}  // namespace

bench::ExitCode run(const bench::CommandLine& line) {
  Options options;
  CLI::App parser("desmo_bench extremes: every formulation in the table of extremes");
  bench::add_common(
      parser, options,
      {.quick = "four formulations, unless --filter names others, and cases that take seconds",
       .filtered = "the formulation's id",
       .repetitions = {}});
  parser.add_option("--row", options.rows, "Only these rows of the table")->type_name("N");
  parser
      .add_option("--case", options.cases,
                  "Only where this regular expression is found in the name of the case")
      ->type_name("REGEX");
  if (!bench::read(parser, line.arguments)) return bench::success;
  return measure(options, line) ? bench::success : bench::not_solved;
}

}  // namespace desmo::extremes
