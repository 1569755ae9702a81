// desmo solve: the motion of a scene, as numbers.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <stdexcept>

#include "bench/cli/commands.h"
#include "bench/cli/drawing_notes.h"
#include "bench/cli/errors.h"
#include "bench/cli/interruption.h"
#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/check_option.h"
#include "bench/cli/solve/failure_notes.h"
#include "bench/cli/solve/run_notes.h"
#include "bench/cli/solve/task.h"
#include "cases/mechanism/names.h"
#include "formulations/id.h"
#include "formulations/variants.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo::cli {
namespace {

/// Returns the format that is asked for: by --format, or by how the name of the output ends.
SeriesFormat format_of(const SolveOptions& options) {
  if (options.format) return *options.format;
  const std::string ending = std::filesystem::path(options.output).extension().string();
  if (ending.empty() || ending == ".csv") return SeriesFormat::csv;
  if (ending == ".jsonl") return SeriesFormat::jsonl;
  throw CommandError(usage_error, "--output " + desmo::in_quotes(options.output) + ": the ending " +
                                      desmo::in_quotes(ending) +
                                      " is not known; known are .csv and .jsonl (or say --format)");
}

Configuration choose_formulation(const SolveOptions& options, const Input& input) {
  const std::string& id = !options.formulation.empty()       ? options.formulation
                          : !input.scene.formulation.empty() ? input.scene.formulation
                                                             : default_formulation;
  const auto refuse = [&](const std::string& what) {
    if (!options.formulation.empty()) throw CommandError(usage_error, what);
    throw InputError(input.source + ": /formulation: " + what);
  };
  const std::string variant = id.substr(0, id.find('/'));
  if (const std::string reason = unavailable_reason(variant); !reason.empty())
    refuse("formulation " + desmo::in_quotes(variant) + ": " + printable(reason, 500));
  std::vector<std::string_view> ids;
  for (const Variant& v : variants()) ids.push_back(v.id);
  if (std::ranges::find(ids, variant) == ids.end())
    refuse(unknown_name("formulation", variant, ids) + " ('desmo list formulations' shows all)");
  try {
    const Configuration chosen = parse_id(id, Settings{.tolerance = input.scene.tolerance});
    if (chosen.settings.coordinates != Modelling::natural)
      refuse("formulation " + desmo::in_quotes(id) +
             ": only natural coordinates are solved here, for proofs speak of them; leave out "
             "'/coordinates:…' ('desmo inspect --coordinates' shows the others)");
    return chosen;
  } catch (const std::invalid_argument& error) {
    refuse(printable(error.what(), 500));
    throw;
  }
}

void say(const std::string& text) {
  std::fputs(text.c_str(), stderr);
  std::fflush(stderr);
}

PlanExtent extent_of(CheckMode mode) {
  return mode == CheckMode::none        ? PlanExtent::outputs
         : mode == CheckMode::mechanism ? PlanExtent::mechanism
                                        : PlanExtent::left_out_equations;
}

/// kernels: receives generated code, and must outlive the formulation.
std::unique_ptr<Formulation> make_solver(const Task& task, KernelTable& kernels) {
  // A formulation that the user has not named is not worth the wait for a compiler.
  if (task.named)
    add_missing_code(kernels, task.chosen, task.plan.model, task.input.scene.grid,
                     task.options.own_code, task.options.quiet);
  auto formulation =
      make_formulation(*task.chosen.variant, task.plan.model, task.chosen.settings, kernels);
  formulation->solve_only(task.plan.levels);
  if (!task.options.quiet) say(note_on_code(*formulation, task.named));
  return formulation;
}

/// Runs through the motion and writes its rows.
CheckedSummary run_through(const Task& task, Formulation& formulation, SeriesWriter& writer) {
  CheckOptions check = task.options.check;
  check.levels = task.plan.levels;
  check.checked = [&](const CheckedInstant& i) {
    if (i.flag) writer.remark_next(word_of(*i.flag));
  };
  return run_checked(formulation, task.input.scene.grid, Request{task.plan.level()}, writer, check);
}

/// Throws CommandError (not_solved) where the run failed or --strict refuses it. First writes the
/// remaining rows; on failure to standard output only, since a file is written whole or not at all.
void require_success(const Task& task, const CheckedSummary& summary, SeriesWriter& writer) {
  const auto fail = [&](const std::string& what, long instants) {
    std::string text = task.input.source + ": " + what;
    if (task.output.is_standard_output())
      text += "\ndesmo: instants before it, on standard output: " + std::to_string(instants);
    throw CommandError(not_solved, text);
  };
  const Model& m = task.plan.model;
  const DisplayUnits& units = task.input.units;
  const std::string overflow = writer.overflow();
  const bool all = summary.outcome() != Outcome::failed && overflow.empty();
  if (all || task.output.is_standard_output()) writer.flush();
  if (!all && !summary.refused)
    say(note_on_gaps(summary, m, units) + note_on_flags(summary, m, units));
  if (!overflow.empty()) fail(overflow, summary.instants - 1);
  if (summary.refused) fail(refusal_text(summary, m, units), summary.instants);
  if (!all) {
    // Without a failure that ended the run, all instants are in gaps.
    const CheckedSummary failure =
        summary.ok() ? failure_of(summary.gaps.front(), summary) : summary;
    fail(failure_text(failure, m, units), summary.instants);
  }
}

/// Returns the notes on a motion; for a quiet run, those on gaps and flags.
std::string notes_on(const Task& task, const Formulation& formulation,
                     const CheckedSummary& summary) {
  const Model& m = task.plan.model;
  const DisplayUnits& units = task.input.units;
  const std::string gaps = note_on_gaps(summary, m, units);
  if (task.options.quiet) return gaps + note_on_flags(summary, m, units);
  return note_on_tolerance(formulation, task.chosen.settings.tolerance) +
         note_on_refusals(formulation, task.named) + note_on_steps(formulation) + gaps +
         note_on_unseen(task.plan, task.whole) +
         note_on_proofs(summary, task.options.check, m, units);
}

void solve_motion(const Task& task, Formulation& formulation) {
  const TimeGrid& grid = task.input.scene.grid;
  const bool in_the_way = task.output.is_standard_output() && ::isatty(STDOUT_FILENO) == 1;
  std::optional<bench::Progress> progress;
  if (!task.options.quiet && !in_the_way) progress.emplace("instants", grid.instants, true);
  SeriesWriter writer(task.heading, task.measures, task.output, progress ? &*progress : nullptr);
  const CheckedSummary summary = run_through(task, formulation, writer);
  progress.reset();
  require_success(task, summary, writer);
  task.output.finish();
  say(notes_on(task, formulation, summary));
}

void solve(const SolveOptions& options) {
  if (options.scene == "-" && options.drivers == "-")
    throw CommandError(usage_error,
                       "scene and drivers both on standard input; give a file for one");
  if (options.drivers.empty() && options.check.past_failures &&
      options.check.mode == CheckMode::none)
    throw CommandError(
        usage_error,
        "--past-failures with --check none: only a run that is checked goes on after "
        "a failure; leave one of them out");
  const SeriesFormat format = format_of(options);
  const Input input = load_scene(options.scene, options.units);
  const Configuration chosen = choose_formulation(options, input);
  protect_input(options.output, input, options.drivers);
  OutputFile output(options.output, remove_when_interrupted);
  const Model whole = model_mechanism(input).model;
  if (!options.quiet) say(note_on_drawing(input.scene.mechanism, whole, input.units));
  const Plan plan = make_plan(whole, outputs_of(input, whole), extent_of(options.check.mode));
  using enum Measures::DrivenBy;
  Measures measures(input.scene, plan.model, options.drivers.empty() ? motions : rows);
  if (options.explain) say(explain(plan, whole));
  const bool named = !options.formulation.empty() || !input.scene.formulation.empty();
  const SeriesHeading heading{format,
                              whole.name,
                              input.scene.name,
                              id_with(*chosen.variant, chosen.settings),
                              make_columns(plan, measures, input),
                              !options.drivers.empty()                         ? "outcome"
                              : options.flags || format == SeriesFormat::jsonl ? "flag"
                                                                               : "",
                              options.drivers.empty() ? input.scene.grid : TimeGrid{}};
  const Task task{options, input, chosen, whole, plan, measures, heading, output, named};
  KernelTable kernels;
  const auto formulation = make_solver(task, kernels);
  if (options.drivers.empty())
    solve_motion(task, *formulation);
  else
    solve_rows(task, *formulation);
}

}  // namespace

void add_solve(CLI::App& program) {
  const auto [command, options] =
      add_command(program, "solve", "Solve a scene and write what it asks for", solve);
  add_scene(command, options.scene);
  add_output(command, options.output);
  add_choice(command, "--format", options.format,
             {{"csv", SeriesFormat::csv}, {"jsonl", SeriesFormat::jsonl}},
             "csv, or jsonl (JSON lines); by default as the name of the output ends, in .csv or "
             ".jsonl");
  add_units(command, options.units);
  command
      .add_option("--formulation", options.formulation,
                  "Formulation (see desmo list formulations), settings as suffixes such as "
                  "/guess:hermite5; by default the scene's, or " +
                      std::string(default_formulation))
      ->check(refuse_empty);
  command
      .add_option("--drivers", options.drivers,
                  "Take the drivers' values from this file, - for standard input: a line for each "
                  "instant, answered at once, of t, then z of each driver, dz/dt of each and "
                  "d2z/dt2 of each; the scene's own motion and time are not used")
      ->check(refuse_empty);
  add_choice(
      command, "--columns", options.flags, {{"flag", true}},
      "Further columns: flag, which says of each row why it is not proven, or that it is beyond "
      "a change point; JSON lines have it anyway")
      ->excludes("--drivers");
  add_check(command, options.check);
  add_options(command, options.own_code);
  command.add_flag("--explain", options.explain,
                   "Say on standard error what has to be solved for what is asked, and why");
  CLI::Option* past_failures = command.add_flag(
      "--past-failures", options.check.past_failures,
      "Go on after an interval that cannot be assembled, and say from when to when");
  command.add_flag("--strict", options.check.strict, "Fail at the first row that is flagged")
      ->excludes(past_failures);
  add_quiet(command, options.quiet);
  command.footer(
      "Examples:\n"
      "  desmo solve slider_crank -o motion.csv\n"
      "  desmo solve mine.scene.json --format jsonl --units si | program\n"
      "  echo 0 90 360 0 | desmo solve slider_crank --drivers -\n"
      "  desmo solve truck_suspension:5 --formulation group_symbolic_klu --quiet -o truck.csv");
}

}  // namespace desmo::cli
