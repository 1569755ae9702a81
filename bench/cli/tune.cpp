// desmo tune: the cheapest settings that are accurate enough for a scene, on this machine.
#include <cmath>
#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/interruption.h"
#include "bench/cli/own_code.h"
#include "bench/cli/text.h"
#include "bench/experiments/accuracy/search.h"
#include "cases/io/new_files.h"
#include "cases/io/scene_text.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/base/per_level.h"
#include "formulations/verification/condition.h"

namespace desmo::cli {
namespace {

constexpr std::size_t rows_shown = 12;  // rows of the table of evidence, its heading included

struct TuneOptions {
  std::string scene;
  accuracy::Goal goal;
  bool write = false, quiet = false;
  GenerationOptions own_code;
};

std::string microseconds(double seconds) { return formatted("%.4g us", 1e6 * seconds); }

/// Returns a table of the configurations that are more accurate than every faster one that was
/// tried.
std::string evidence(const accuracy::SearchResult& found) {
  std::vector<std::vector<std::string>> rows{{"us/step", "error", "motion", "formulation"}};
  double best = INFINITY;
  for (const accuracy::TriedConfiguration& t : found.tried) {
    if (!(t.error < best)) continue;
    best = t.error;
    rows.push_back({formatted("%.4g", 1e6 * t.seconds), formatted("%.2g", t.error),
                    t.whole ? "whole" : "beginning", t.id});
  }
  if (rows.size() > rows_shown) rows.resize(rows_shown);
  return "Tried: " + count(static_cast<long>(found.tried.size()), "configuration") +
         "; each of these is more accurate than every faster one:\n" + table(rows, "rr");
}

[[noreturn]] void refuse(const accuracy::SearchResult& found, const accuracy::Problem& whole,
                         const TuneOptions& options, const Input& input) {
  const accuracy::TriedConfiguration* nearest = nullptr;
  const bool budget = options.goal.budget > 0;
  // Without a budget, errors over the whole motion come first: one on its beginning says little.
  const auto rank = [&](const accuracy::TriedConfiguration& t) {
    return budget ? std::pair(false, t.seconds) : std::pair(!t.whole, t.error);
  };
  for (const accuracy::TriedConfiguration& t : found.tried)
    if (!nearest || rank(t) < rank(*nearest)) nearest = &t;
  std::string text = input.source + ": ";
  if (budget)
    text += "nothing takes at most " + microseconds(options.goal.budget) + " a step here";
  else
    text += "nothing holds a relative " + std::string(level_names[options.goal.level]) +
            " error of " + formatted("%.2g", options.goal.max_error);
  if (nearest)
    text += "; the " + std::string(budget ? "fastest" : "most accurate") + " is " + nearest->id +
            " with " + formatted("%.2g", nearest->error) + " in " + microseconds(nearest->seconds);
  if (!budget)
    text += "; conditioning sets a floor of the order of " +
            formatted("%.1g", accuracy_limit(accuracy::max_condition(whole),
                                             std::ldexp(1, -53))[options.goal.level]);
  throw CommandError(not_solved, text + "; ask for " + (budget ? "more time" : "a larger error"));
}

void write_scene(const std::string& path, const std::string& id) {
  const std::string text = with_formulation(read_named_text(path), id);
  OutputFile output(path, remove_when_interrupted);
  output.write(text);
  output.finish();
}

/// Returns the code that can be generated for groups and for blocks, lanes included.
KernelTable make_kernels(const Plan& plan, const TimeGrid& grid, const TuneOptions& options) {
  KernelTable kernels;
  for (const char* id : {"group_symbolic_explicit/lanes:4", "block_symbolic_explicit/lanes:4"})
    add_missing_code(kernels, parse_id(id), plan.model, grid, options.own_code, options.quiet);
  return kernels;
}

/// Returns the motion with its reference solutions. Throws CommandError (not_solved) where they
/// cannot be made, for instance since the mechanism locks or is singular.
accuracy::TunedMotion motion_of(const Plan& plan, const Input& input) {
  try {
    return accuracy::make_tuned_motion(plan, input.scene.grid);
  } catch (const std::runtime_error& error) {
    throw CommandError(not_solved, input.source + ": " + printable(error.what(), 500) +
                                       "; choose a motion that 'desmo solve' proves");
  }
}

void tune(const TuneOptions& options) {
  if ((options.goal.max_error > 0) == (options.goal.budget > 0))
    throw CommandError(usage_error, "give either --max-error or --budget");
  const Input input = load_scene(options.scene);
  if (options.write && (input.file.empty() || options.scene == "-"))
    throw CommandError(usage_error, "--write: " + input.source +
                                        " is not a scene file; save it first " +
                                        "('desmo show NAME --scene') and tune that");
  const Model whole_model = model_mechanism(input).model;
  const Plan plan = make_plan(whole_model, outputs_of(input, whole_model));
  if (plan.level() < options.goal.level)
    throw CommandError(usage_error, "--level " + std::string(level_names[options.goal.level]) +
                                        ": the scene does not ask for any");
  const auto say = [&](const std::string& what) {
    if (!options.quiet) std::fprintf(stderr, "tune: %s\n", what.c_str());
  };
  const KernelTable kernels = make_kernels(plan, input.scene.grid, options);
  say("reference solutions in quadruple precision");
  accuracy::TunedMotion motion = motion_of(plan, input);
  motion.whole.kernels = motion.beginning.kernels = kernels;
  const accuracy::SearchResult found = accuracy::search(motion, options.goal, {.say = say});
  if (!found.choice) refuse(found, motion.whole, options, input);

  const std::string id = id_with(*found.choice->variant, found.choice->settings);
  std::string text = id + "\nrelative error over the motion: position " +
                     formatted("%.2g", found.error.position.max);
  for (const Level level : rate_levels)
    if (found.error[level].compared > 0)
      text += formatted(", %s %.2g", level_names[level], found.error[level].max);
  text += " (at " + count(found.error.instants, "instant") + ")\n" + microseconds(found.seconds) +
          " a step, " + formatted("%.2f", found.usual_seconds / found.seconds) +
          " times as fast as " + found.choice->variant->id + " with the usual settings\n\n" +
          evidence(found);
  if (options.write) {
    write_scene(options.scene, id);
    text += "\nWritten to " + input.source + " as its formulation.\n";
  }
  write_standard_output(text);
}

}  // namespace

void add_tune(CLI::App& program) {
  const auto [command, options] = add_command(
      program, "tune",
      "Find the cheapest formulation and settings that are accurate enough for a scene", tune);
  add_scene(command, options.scene);
  command
      .add_option("--max-error", options.goal.max_error,
                  "Largest error, relative to the size (speed, acceleration) of the mechanism")
      ->check(require_positive);
  command
      .add_option("--budget", options.goal.budget,
                  "Time that a step may take, such as 50us: the most accurate within it. "
                  "Either --max-error or --budget is required")
      ->transform(CLI::AsNumberWithUnit(
          std::map<std::string, double>{{"s", 1}, {"ms", 1e-3}, {"us", 1e-6}, {"ns", 1e-9}},
          CLI::AsNumberWithUnit::UNIT_REQUIRED, "TIME"))
      ->check(require_positive);
  Choices<Level> levels;
  for (const Level level : all_levels) levels.emplace_back(level_names[level], level);
  add_choice(command, "--level", options.goal.level, levels,
             "Which error is meant; position by default");
  command.add_flag("--write", options.write, "Store the choice in the scene file");
  add_options(command, options.own_code);
  command.add_flag("--quiet", options.quiet, "No progress");
  command.footer(
      "Examples:\n"
      "  desmo tune slider_crank --max-error 1e-9\n"
      "  desmo tune mine.scene.json --budget 20us --level acceleration --write");
}

}  // namespace desmo::cli
