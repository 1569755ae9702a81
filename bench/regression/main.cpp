// desmo_check: measures the programs of two trees, or of one, for bench/check. `desmo_report check`
// judges the results file that it writes.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <csignal>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/candidate_name.h"
#include "bench/kit/exit_codes.h"
#include "bench/regression/counts.h"
#include "bench/regression/rounds.h"
#include "cases/io/new_files.h"
#include "results/schema_version.h"

namespace desmo::regression {

namespace {

using Json = nlohmann::ordered_json;
using Names = std::vector<std::string>;

struct Options {
  std::string base, head, file, slow;
  Names names;
  Commit commit;
  std::string pass;  ///< "first" or "second"
  std::uint64_t seed = 1;
  bool time = true, work = true;
};

/// Runs a side's desmo_probe with some arguments. Returns what it writes to standard output.
std::string answer_of(const Side& side, std::vector<std::string> question) {
  std::string answer;
  const int code = bench::Child(side.probe(std::move(question))).finish(answer);
  if (code != 0)
    throw std::runtime_error(side.folder + "/desmo_probe ended with exit code " +
                             std::to_string(code));
  return answer;
}

/// Returns the names of the candidates that bench/check measures, as head's desmo_probe lists them.
Names all_names(const Side& head) {
  std::istringstream answer(answer_of(head, {"names"}));
  return {std::istream_iterator<std::string>(answer), {}};
}

void require_known(const Names& all, const std::string& name, const std::string& option) {
  if (std::ranges::find(all, name) == all.end())
    throw std::invalid_argument(option + ": there is no candidate '" + name + "'");
}

/// Makes a candidate of a side slower, as SIDE:CANDIDATE:PERCENT says.
void make_slower(std::vector<Side>& sides, const std::string& slow) {
  const std::size_t first = slow.find(':'), last = slow.rfind(':');
  for (Side& side : sides) {
    if (first == last || side.name != slow.substr(0, first)) continue;
    side.slowed = slow.substr(first + 1, last - first - 1);
    side.percent = bench::whole_number(slow.substr(last + 1), 1, 90);
    return require_known(all_names(sides.back()), side.slowed, "--slow");
  }
  throw std::invalid_argument("--slow: '" + slow + "' is not SIDE:CANDIDATE:PERCENT");
}

std::vector<Side> sides_of(const Options& o) {
  std::vector<Side> sides;
  if (!o.base.empty()) sides.push_back({"base", o.base, {}, 0});
  sides.push_back({"head", o.head, {}, 0});
  if (!o.slow.empty()) make_slower(sides, o.slow);
  return sides;
}

std::string name_of(const Json& candidate) {
  return bench::CandidateName{candidate["case"], candidate["coordinates"], candidate["id"]}.text();
}

/// Turns a record of schema 2, which calls candidates cells, into one of the current schema.
void bring_up_to_date(Json& record) {
  Json& paper = record["paper"];
  if (!paper.contains("cells")) return;
  paper["candidates"] = paper["cells"];
  paper.erase("cells");
  record["schema_version"] = schema_version;
}

/// Returns a record for each side, under its name, made by verifying the named candidates there.
Json verified(const std::vector<Side>& sides, const Names& names) {
  std::vector<std::string> question{"verify", std::to_string(TimingSettings::instants)};
  question.insert(question.end(), names.begin(), names.end());
  Json records;
  for (const Side& side : sides) {
    records[side.name] = Json::parse(answer_of(side, question));
    bring_up_to_date(records[side.name]);
  }
  return records;
}

/// Returns the names of the candidates that are right on all sides. A candidate that is wrong on
/// one side is never measured, and one that a side lacks cannot be compared.
Names right_on_all_sides(Names candidates, const Json& check, const std::vector<Side>& sides) {
  for (const Side& side : sides)
    for (const Json& candidate : check[side.name]["paper"]["candidates"])
      if (candidate["status"] != "ok") std::erase(candidates, name_of(candidate));
  return candidates;
}

/// Adds the samples of a pass: those of the first pass to the sides' records, those of the second
/// to a list of their own.
void add_times(Json& check, const std::string& pass, const Times& times) {
  if (pass == "second") {
    for (const auto& [candidate, by_side] : times)
      for (const auto& [side, seconds] : by_side)
        for (const double s : seconds) check["second"][candidate][side].push_back(s);
    return;
  }
  for (const auto& [side, seconds] : times.at(control_name)) {
    for (const double s : seconds) check[control_name][side].push_back(s);
    for (Json& candidate : check[side]["paper"]["candidates"]) {
      const auto timed = times.find(name_of(candidate));
      if (timed == times.end()) continue;
      candidate["time"]["clock"] = "cpu";
      for (const double s : timed->second.at(side)) candidate["time"]["seconds"].push_back(s);
    }
  }
}

/// Marks as not run all candidates that are right and were not timed, for whatever reason.
void mark_untimed(Json& check, const std::vector<Side>& sides) {
  for (const Side& side : sides)
    for (Json& candidate : check[side.name]["paper"]["candidates"]) {
      if (candidate["status"] != "ok" || candidate.contains("time")) continue;
      candidate["status"] = "not_run";
      candidate["message"] = "verified, not timed";
    }
}

Json load(const std::string& path) {
  std::ifstream in(path);
  try {
    return Json::parse(in);
  } catch (const nlohmann::json::exception& e) {
    throw std::runtime_error("'" + path + "' is not a results file: " + e.what());
  }
}

void save(const std::string& text, const std::string& path) {
  OutputFile output(path);
  output.write(text);
  output.finish();
}

void measure(const Options& o) {
  if (o.time && o.base.empty())
    throw std::invalid_argument("times need --base: head alone is counted (--no-time)");
  const std::vector<Side> sides = sides_of(o);
  const Names all = all_names(sides.back());
  for (const std::string& name : o.names) require_known(all, name, "--candidate");
  const Names& chosen = o.names.empty() ? all : o.names;
  Json check = {{"schema", "desmo-check"}, {"schema_version", schema_version}};
  check["settings"] = {{"seed", o.seed},
                       {"turns", TimingSettings::turns},
                       {"repetitions", TimingSettings::repetitions}};
  if (!o.slow.empty()) check["settings"]["slowed"] = o.slow;
  check.update(verified(sides, chosen));
  const Names names = right_on_all_sides(chosen, check, sides);
  if (o.work) check["work"] = counted_work(names, sides);
  if (o.time) add_times(check, "first", time_rounds(sides, names, TimingSettings::rounds, o.seed));
  mark_untimed(check, sides);
  save(check.dump() + '\n', o.file);
}

/// Adds rounds of some candidates to the first pass, or to the second, which confirms an alarm.
void measure_more(Options o) {
  Json check = load(o.file);
  if (check["settings"].contains("slowed")) o.slow = check["settings"]["slowed"];
  const std::uint64_t seed = check["settings"]["seed"];
  const std::uint64_t added = check.dump().size();  // changes the order of candidates in each call
  add_times(check, o.pass, time_rounds(sides_of(o), o.names, TimingSettings::rounds, seed + added));
  save(check.dump() + '\n', o.file);
}

void add_commit(const Options& o) {
  Json history = std::filesystem::exists(o.file) ? load(o.file) : Json{};
  add_point(history, sides_of(o).back(), o.commit, o.names);
  save(text_of(history), o.file);
}

int run(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // so that Child::say() reports that a probe has ended
  Options o;
  CLI::App app{"Measures trees for bench/check"};
  app.require_subcommand(1);
  app.add_option("--head", o.head, "Folder of head's desmo_probe and desmo_steps")->required();
  app.add_option("--base", o.base, "The same of base; without it head is measured alone");
  CLI::App* all = app.add_subcommand("measure", "Verifies, counts and times every candidate");
  all->add_option("file", o.file, "Results file to write")->required();
  all->add_option("--slow", o.slow,
                  "SIDE:CANDIDATE:PERCENT: make a candidate slower, to test the check");
  all->add_option("--candidate", o.names, "Measure only these");
  all->add_flag("!--no-time", o.time, "Count instructions only");
  all->add_flag("!--no-work", o.work, "Measure times only");
  CLI::App* more = app.add_subcommand("more", "Adds rounds of some candidates to a results file");
  more->add_option("file", o.file, "Results file")->required();
  more->add_option("pass", o.pass)->required()->check(CLI::IsMember({"first", "second"}));
  more->add_option("candidates", o.names)->required();
  CLI::App* history = app.add_subcommand("history", "Counts a commit's candidates and adds them");
  history->add_option("file", o.file, "History to add to; made where there is none")->required();
  history->add_option("--commit", o.commit.name)->required();
  history->add_option("--date", o.commit.date)->required();
  history->add_option("--subject", o.commit.message)->required();
  history->add_option("candidates", o.names)->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? bench::success : bench::usage_error;
  }
  if (all->parsed())
    measure(o);
  else if (more->parsed())
    measure_more(o);
  else
    add_commit(o);
  return 0;
}

}  // namespace

}  // namespace desmo::regression

int main(int argc, char** argv) {
  try {
    return desmo::regression::run(argc, argv);
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_check: " << e.what() << '\n';
    return desmo::bench::usage_error;
  } catch (const std::exception& e) {
    std::cerr << "desmo_check: " << e.what() << '\n';
    return desmo::bench::not_completed;
  }
}
