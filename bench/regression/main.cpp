// desmo_check: measures two trees, or one, for bench/check. It judges nothing: `desmo_report check`
// reads what it has written.

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <csignal>
#include <cstdint>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/process/callgrind.h"
#include "bench/kit/record/schema_version.h"
#include "bench/regression/cells.h"
#include "bench/regression/check_file.h"
#include "bench/regression/counts.h"
#include "bench/regression/rounds.h"
#include "bench/regression/side.h"

namespace desmo::regression {

namespace {

struct Options {
  std::string base, head, file, slow;
  std::vector<std::string> cells{checked_cells.begin(), checked_cells.end()};
  std::string pass = "first";
  std::uint64_t seed = 1;
  bool time = true, work = true;
};

/// SIDE:CELL:PERCENT into the side that it names.
void make_slower(std::vector<Side>& sides, const std::string& slow) {
  const std::size_t first = slow.find(':'), last = slow.rfind(':');
  for (Side& side : sides) {
    if (first == last || side.name != slow.substr(0, first)) continue;
    side.slowed = slow.substr(first + 1, last - first - 1);
    const std::string percent = slow.substr(last + 1);
    const char* const end = percent.data() + percent.size();
    if (std::from_chars(percent.data(), end, side.percent).ptr != end || side.percent < 1 ||
        side.percent > 90)
      throw std::invalid_argument("--slow: '" + percent + "' is not a percentage from 1 to 90");
    if (std::ranges::find(checked_cells, side.slowed) != checked_cells.end()) return;
    throw std::invalid_argument("--slow: there is no cell '" + side.slowed + "'");
  }
  throw std::invalid_argument("--slow: '" + slow + "' is not SIDE:CELL:PERCENT");
}

std::vector<Side> sides_of(const Options& o) {
  std::vector<Side> sides;
  if (!o.base.empty()) sides.push_back({"base", o.base, {}, 0});
  sides.push_back({"head", o.head, {}, 0});
  if (!o.slow.empty()) make_slower(sides, o.slow);
  return sides;
}

Json asked(const Side& side, std::vector<std::string> question) {
  std::string answer;
  const int code = run_to_end(side.probe(std::move(question)), answer);
  if (code != 0)
    throw std::runtime_error(side.folder + "/desmo_probe ended with exit code " +
                             std::to_string(code));
  return Json::parse(answer);
}

std::string name_of(const Json& cell) {
  return cell["case"].get<std::string>() + "/" + std::to_string(cell["coordinates"].get<int>()) +
         "/" + cell["id"].get<std::string>();
}

/// The record of each side, with every cell verified.
Json verified(const std::vector<Side>& sides, const std::vector<std::string>& cells) {
  std::vector<std::string> question{"verify", std::to_string(instants)};
  question.insert(question.end(), cells.begin(), cells.end());
  Json records;
  for (const Side& side : sides) records[side.name] = asked(side, question);
  return records;
}

/// What is wrong on one side is never measured, and what one side lacks cannot be compared.
std::vector<std::string> sound_cells(std::vector<std::string> sound, const Json& check,
                                     const std::vector<Side>& sides) {
  for (const Side& side : sides)
    for (const Json& cell : check[side.name]["paper"]["cells"])
      if (cell["status"] != "ok") std::erase(sound, name_of(cell));
  return sound;
}

void append(Json& samples, const std::vector<double>& seconds) {
  for (const double value : seconds) samples.push_back(value);
}

/// The samples of a pass: the first is in the records, beside what verified the cells.
void add_times(Json& check, const std::string& pass, const Times& times) {
  if (pass == "second") {
    for (const auto& [cell, by_side] : times)
      for (const auto& [side, seconds] : by_side) append(check["second"][cell][side], seconds);
    return;
  }
  for (const auto& [side, seconds] : times.at(control)) append(check[control][side], seconds);
  for (const auto& [side, ignored] : times.at(control))
    for (Json& cell : check[side]["paper"]["cells"]) {
      const auto timed = times.find(name_of(cell));
      if (timed == times.end()) continue;
      cell["time"]["clock"] = "cpu";
      append(cell["time"]["seconds"], timed->second.at(side));
    }
}

/// A sound cell has no time when it was not timed, for whatever reason.
void mark_untimed(Json& check, const std::vector<Side>& sides) {
  for (const Side& side : sides)
    for (Json& cell : check[side.name]["paper"]["cells"]) {
      if (cell["status"] != "ok" || cell.contains("time")) continue;
      cell["status"] = "not_run";
      cell["message"] = "verified, not timed";
    }
}

Json counted(const std::vector<std::string>& cells, const std::vector<Side>& sides) {
  std::vector<Counted> all;
  for (const std::string& cell : cells)
    for (const Side& side : sides) all.push_back({&side, cell});
  return {{"tool", counting_tool()},
          {"steps", steps - uncounted_steps},
          {"iterations", iterations},
          {"instructions", count_instructions(all)}};
}

void measure(const Options& o) {
  const std::vector<Side> sides = sides_of(o);
  Json check = {{"schema", "desmo-check"}, {"schema_version", bench::schema_version}};
  check["settings"] = {{"seed", o.seed}, {"turns", turns}, {"repetitions", repetitions}};
  if (!o.slow.empty()) check["settings"]["slowed"] = o.slow;
  check.update(verified(sides, o.cells));
  const std::vector<std::string> cells = sound_cells(o.cells, check, sides);
  if (o.work) check["work"] = counted(cells, sides);
  if (o.time) add_times(check, "first", time_rounds(sides, cells, rounds, o.seed));
  mark_untimed(check, sides);
  save_check(check, o.file);
}

/// Further rounds of some cells, in the first pass or in the second, which confirms it.
void measure_more(Options o) {
  Json check = load_check(o.file);
  if (check["settings"].contains("slowed")) o.slow = check["settings"]["slowed"];
  const std::uint64_t seed = check["settings"]["seed"];
  const std::uint64_t added = check.dump().size();  // another order whenever something was added
  add_times(check, o.pass, time_rounds(sides_of(o), o.cells, rounds, seed + added));
  save_check(check, o.file);
}

int run(int argc, char** argv) {
  std::signal(SIGPIPE, SIG_IGN);  // a probe that has ended is an error with a message
  Options o;
  CLI::App app{"Measures trees for bench/check"};
  app.require_subcommand(1);
  app.add_option("--head", o.head, "Folder of head's desmo_probe and desmo_steps")->required();
  app.add_option("--base", o.base, "The same of base; without it head is measured alone");
  CLI::App* all = app.add_subcommand("measure", "Verifies, counts and times every cell");
  all->add_option("file", o.file, "Results file to write")->required();
  all->add_option("--seed", o.seed, "Of the order in which things are measured");
  all->add_option("--slow", o.slow, "SIDE:CELL:PERCENT: make a cell slower, to test the check");
  all->add_option("--cell", o.cells, "Measure only these")
      ->check(CLI::IsMember(std::vector<std::string>(checked_cells.begin(), checked_cells.end())));
  all->add_flag("!--no-time", o.time, "Count instructions only");
  all->add_flag("!--no-work", o.work, "Measure times only");
  CLI::App* more = app.add_subcommand("more", "Adds rounds of some cells to a results file");
  more->add_option("file", o.file, "Results file")->required();
  more->add_option("pass", o.pass)->required()->check(CLI::IsMember({"first", "second"}));
  more->add_option("cells", o.cells)->required();
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 64;
  }
  if (all->parsed())
    measure(o);
  else
    measure_more(o);
  return 0;
}

}  // namespace

}  // namespace desmo::regression

int main(int argc, char** argv) {
  try {
    return desmo::regression::run(argc, argv);
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_check: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_check: " << e.what() << '\n';
    return 74;
  }
}
