// Drawn scenes: every number is within its radius of the answer, or its row is flagged.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iostream>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "formulations/base/per_level.h"
#include "tests/properties/formulations.h"
#include "tests/properties/judge.h"
#include "tests/properties/options.h"

namespace desmo::properties::properties_test {
namespace {

/// Numbers of instants of one kind of scene, or of all.
struct Tally {
  long scenes = 0, runs = 0, rows = 0, regular = 0;
  std::map<std::string, long> flags{}, regular_flags{};

  void add(const Judgement& j) {
    ++runs;
    rows += j.rows;
    regular += j.regular;
    for (const auto& [word, count] : j.flags) flags[word] += count;
    for (const auto& [word, count] : j.regular_flags) regular_flags[word] += count;
  }
};

std::string listed(const std::map<std::string, long>& counts) {
  std::string text;
  for (const auto& [word, count] : counts) text += " " + word + " " + std::to_string(count);
  return text.empty() ? " none" : text;
}

void print(const std::string& name, const Tally& t) {
  std::cout << formatted("%-14s %5ld scenes %6ld runs %8ld rows, flagged:%s; %ld regular:%s\n",
                         name.c_str(), t.scenes, t.runs, t.rows, listed(t.flags).c_str(), t.regular,
                         listed(t.regular_flags).c_str());
}

/// Returns how to see a run again: the command, and the scene's file if files are written.
std::string repeated(const DrawnScene& s, const std::string& id) {
  const Options& o = options();
  std::string text = formatted("  properties_test --seed %llu --scene %d --formulation %s\n",
                               static_cast<unsigned long long>(o.seed), s.number, id.c_str());
  if (o.failures.empty()) return text;
  std::filesystem::create_directories(o.failures);
  const std::string file =
      (std::filesystem::path(o.failures) /
       formatted("seed%llu-scene%d.json", static_cast<unsigned long long>(o.seed), s.number))
          .string();
  std::ofstream(file) << s.text;
  return text + "  desmo solve " + file + " -o out.csv --columns flag --formulation " + id + "\n";
}

void report(const DrawnScene& s, const std::string& id, const Judgement& j) {
  const std::string scene = formatted("scene %d: %s, %s, %s, %s", s.number, s.kind.c_str(),
                                      s.family.c_str(), s.aim.c_str(), id.c_str());
  if (j.wrong) {
    const Finding& f = *j.wrong;
    ADD_FAILURE() << scene << ": " << f.what
                  << formatted(": %s, %s: error %.3e, radius %.3e, t = %.17g s, condition %.1e\n",
                               f.coordinate.c_str(), level_names[f.level], f.error, f.radius,
                               f.time, f.condition)
                  << repeated(s, id);
  }
  if (j.regular_flags.empty()) return;
  std::cout << scene << ": regular, but" << listed(j.regular_flags);
  if (const auto& f = j.first_regular_flag)
    std::cout << formatted(
        ", first at t = %.17g s, group %d, failure %d, from %.17g to %.17g s, condition %.1e",
        f->time, f->group, static_cast<int>(f->failure), f->after, f->before, j.condition);
  std::cout << '\n' << repeated(s, id);
}

/// Returns the formulations of a scene.
std::vector<std::string> ids_of(int number) {
  const Options& o = options();
  if (!o.id.empty()) return {o.id};
  const std::vector<std::string> all = drawn_ids();
  if (o.ids == 0) return all;
  std::vector<std::string> ids;
  for (int i = 0; i < o.ids; ++i)
    ids.push_back(all[(static_cast<std::size_t>(number) * o.ids + i) % all.size()]);
  return ids;
}

TEST(Properties, EveryNumberIsWithinItsRadiusOrFlagged) {
  const Options& o = options();
  std::map<std::string, Tally> kinds;
  Tally all;
  const int first = o.scene.value_or(0), last = o.scene ? first + 1 : o.scenes;
  for (int number = first; number < last; ++number) {
    const DrawnScene s = draw_scene(o.seed, number);
    Tally& kind = kinds[s.kind];
    ++kind.scenes, ++all.scenes;
    for (const std::string& id : ids_of(number)) {
      const std::optional<CheckedRows> run = solve_checked(s, id);
      if (!run) continue;  // not offered
      const Judgement j = judge(s, *run);
      report(s, id, j);
      kind.add(j), all.add(j);
    }
  }
  for (const auto& [name, tally] : kinds) print(name, tally);
  print("all", all);
  long unproven = 0;
  for (const auto& [word, count] : all.regular_flags) unproven += count;
  EXPECT_LE(static_cast<double>(unproven), 1e-4 * static_cast<double>(all.regular));
  if (!o.scene) EXPECT_GT(all.regular, 10L * o.scenes);  // else the judge looked at little
}

}  // namespace
}  // namespace desmo::properties::properties_test
