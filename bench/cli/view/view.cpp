// desmo view: the mechanism moving, as one page.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <optional>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/interruption.h"
#include "bench/cli/solve/check_notes.h"
#include "bench/cli/solve/columns.h"
#include "bench/cli/view/drawn_entities.h"
#include "bench/cli/view/page_data.h"
#include "bench/cli/view/page_template.h"
#include "cases/io/new_files.h"
#include "formulations/variants.h"

namespace desmo::cli {
namespace {

constexpr std::size_t max_page = 2'000'000;  // largest size of a page [bytes] (≤)
constexpr std::size_t max_instants = 8192;   // largest number of instants kept in memory (≤)
/// Smallest number of instants on a page, unless the scene has fewer: fewer show little.
constexpr std::size_t min_instants = 16;
constexpr double text_per_column = 180;  // bytes of a column in a page, its numbers excepted

struct ViewOptions {
  std::string scene, output;
  UnitSystem units = UnitSystem::file;
  bool quiet = false;
};

void require_page() {
  if (page_template.empty())
    throw CommandError(
        unavailable,
        "this program was built without the scripts of the page; build it where Node.js 18 "
        "or later and npm are installed and packages can be fetched");
}

/// Returns the page with data in place of its mark.
std::string fill(const std::string& data) {
  constexpr std::string_view mark = "@DATA@";
  std::string page(page_template);
  return page.replace(page.find(mark), mark.size(), data);
}

[[noreturn]] void refuse_size(const std::string& source, const Model& model) {
  throw InputError(source + ": a page cannot show a mechanism of " +
                   std::to_string(model.coordinates()) + " coordinates; view a smaller one");
}

/// Returns an estimate of the number of instants for which a page has room. Throws InputError when
/// that is less than min_instants and less than the scene has.
std::size_t instants_that_fit(const Input& input, const Model& model) {
  const auto columns = static_cast<double>(drawn_numbers(input.scene.mechanism));
  const double bytes = static_cast<double>(max_page - page_template.size()) / columns;
  const double fitting = (bytes - text_per_column) / text_per_number;
  if (fitting < std::min<double>(min_instants, input.scene.grid.instants))
    refuse_size(input.source, model);
  return static_cast<std::size_t>(fitting);
}

/// Returns a page of at most max_page bytes. Thins out the recording until it fits. Throws
/// InputError where even few instants are too many.
std::string page_of(const ShownMotion& motion, MotionRecorder& recording,
                    const std::string& source) {
  for (;; recording.thin_out()) {
    std::string result = fill(page_data(motion));
    if (result.size() <= max_page) return result;
    if (recording.instants().size() < min_instants) refuse_size(source, motion.model);
  }
}

void view(const ViewOptions& options) {
  require_page();
  const Input input = load_scene(options.scene, options.units);
  protect_input(options.output, input);
  OutputFile output(options.output, remove_when_interrupted);
  if (output.is_standard_output() && ::isatty(STDOUT_FILENO) == 1)
    throw CommandError(usage_error, "a terminal cannot show a page; give --output FILE.html");
  const Model model = model_mechanism(input).model;
  const Plan plan = make_plan(model, outputs_of(input, model));
  // For its InputError alone: refuses scenes with equal headings, as `desmo solve` does.
  make_columns(plan, Measures(input.scene, plan.model), input);
  Measures measures(input.scene, model);
  const std::size_t fitting = instants_that_fit(input, model);
  const TimeGrid& grid = input.scene.grid;
  const auto formulation = make_formulation(find_variant(default_formulation), model,
                                            {.tolerance = input.scene.tolerance});
  std::optional<bench::Progress> progress;
  if (!options.quiet) progress.emplace("instants", grid.instants, true);
  MotionRecorder recording(model, measures, input.units, grid, std::min(max_instants, fitting),
                           progress ? &*progress : nullptr);
  const CheckedSummary summary = recording.run(*formulation);
  progress.reset();
  if (recording.overflowed())
    throw CommandError(not_solved,
                       input.source + ": a number is not finite; choose another motion");
  output.write(
      page_of({input.scene, input.units, model, measures, recording, summary, default_formulation},
              recording, input.source));
  output.finish();
  const auto& flags = recording.flags();
  const auto failed = std::ranges::find(flags, Flag::Kind::failed, &Flag::kind);
  if (failed != flags.end())
    throw CommandError(not_solved, input.source + ": " + failed->text +
                                       (recording.solved() > 0
                                            ? "\ndesmo: the page shows the last position before it"
                                            : "\ndesmo: the page shows the initial estimate"));
  const std::string note = options.quiet ? note_on_flags(summary, model, input.units)
                                         : note_on_proofs(summary, {}, model, input.units);
  std::fputs(note.c_str(), stderr);
}

}  // namespace

void add_view(CLI::App& program) {
  const auto [command, options] =
      add_command(program, "view", "Show a scene in motion, as one page for a browser", view);
  add_scene(command, options.scene);
  add_output(command, options.output);
  add_units(command, options.units);
  add_quiet(command, options.quiet);
  command.footer(
      "Examples:\n"
      "  desmo view slider_crank -o motion.html\n"
      "  desmo view - -o motion.html < mine.scene.json");
}

}  // namespace desmo::cli
