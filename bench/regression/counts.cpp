#include "bench/regression/counts.h"

#include <algorithm>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bench/kit/candidate_name.h"
#include "bench/kit/exit_codes.h"
#include "bench/kit/process/callgrind.h"

namespace desmo::regression {

namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> steps_command(const Side& side, const std::string& name, int count) {
  const bench::CandidateName parsed = bench::parse_name(name);
  return {side.folder + "/desmo_steps",
          parsed.case_name,
          std::to_string(parsed.coordinates),
          parsed.id,
          std::to_string(count),
          std::to_string(CountingSettings::iterations),
          std::to_string(name == side.slowed ? side.percent : 0)};
}

/// Returns the instructions of all candidates on all sides: those of candidate i on side j have
/// index i · (number of sides) + j.
std::vector<std::int64_t> count_all(const std::vector<std::string>& names,
                                    const std::vector<Side>& sides) {
  std::vector<std::int64_t> instructions(names.size() * sides.size());
  bench::count_on_all_cores(instructions.size(), [&](std::size_t i) {
    const Side& side = sides[i % sides.size()];
    const std::string& name = names[i / sides.size()];
    instructions[i] = bench::count_steps(name + " in " + side.name,
                                         steps_command(side, name, CountingSettings::steps));
  });
  return instructions;
}

/// Returns whether the side's desmo_steps knows a candidate. It refuses others as wrong usage.
bool exists(const Side& side, const std::string& name) {
  std::string output;
  return bench::Child(bench::fixed_launch(steps_command(side, name, 0))).finish(output) !=
         bench::usage_error;
}

/// Returns the index of a name in the history's candidates. Adds the name, and null to all points,
/// where it is missing.
std::size_t place_of(const std::string& name, Json& history) {
  Json& known = history["candidates"];
  const std::size_t place = std::find(known.begin(), known.end(), name) - known.begin();
  if (place == known.size()) {
    known.push_back(name);
    for (Json& point : history["points"]) point["instructions"].push_back(nullptr);
  }
  return place;
}

}  // namespace

Json counted_work(const std::vector<std::string>& names, const std::vector<Side>& sides) {
  const std::vector<std::int64_t> instructions = count_all(names, sides);
  Json counts;
  for (std::size_t i = 0; i < instructions.size(); ++i)
    counts[names[i / sides.size()]][sides[i % sides.size()].name] = instructions[i];
  return {{"tool", bench::counting_tool()},
          {"steps", CountingSettings::steps - CountingSettings::uncounted_steps},
          {"iterations", CountingSettings::iterations},
          {"instructions", counts}};
}

void add_point(Json& history, const Side& programs, const Commit& commit,
               const std::vector<std::string>& names) {
  if (history.empty())
    history = {{"schema", 2}, {"candidates", Json::array()}, {"points", Json::array()}};
  if (history.value("schema", Json()) != 2)
    throw std::runtime_error("the file to add to is not a history");
  std::vector<std::string> counted;
  for (const std::string& name : names) {
    place_of(name, history);
    if (exists(programs, name)) counted.push_back(name);
  }
  const std::vector<std::int64_t> counts = count_all(counted, {programs});

  Json instructions(history["candidates"].size(), nullptr);
  for (std::size_t i = 0; i < counted.size(); ++i)
    instructions[place_of(counted[i], history)] = counts[i];
  const Json point = {{"commit", commit.name},
                      {"date", commit.date},
                      {"subject", commit.message},
                      {"compiler", DESMO_COMPILER ", " + bench::counting_tool()},
                      {"instructions", instructions}};
  Json& points = history["points"];
  const auto later = std::find_if(points.begin(), points.end(), [&](const Json& p) {
    return p["date"].get<std::string>() > commit.date;
  });
  points.insert(later, point);
}

std::string text_of(const Json& history) {
  std::string text = "{\"schema\":2,\"candidates\":" + history["candidates"].dump() +
                     ",\n\"points\":[",
              end;
  for (const Json& point : history["points"]) {
    text += end + "\n" + point.dump();
    end = ",";
  }
  return text + "\n]}\n";
}

}  // namespace desmo::regression
