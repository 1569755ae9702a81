// desmo view: the mechanism moving, as one page.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/input.h"
#include "bench/cli/interruption.h"
#include "bench/cli/view/page_data.h"
#include "bench/cli/view/page_template.h"
#include "cases/io/new_files.h"
#include "formulations/variants.h"

namespace desmo::cli {
namespace {

constexpr const char* formulation_id = "block_symbolic_inlined";
constexpr std::size_t max_page = 2'000'000;                           // bytes
constexpr std::size_t max_instants = 8192, max_numbers = 40'000'000;  // kept in memory
constexpr int max_coordinates = 10'000;                               // drawn in every frame

struct ViewOptions {
  std::string scene, output;
  bool quiet = false;
};

std::string_view template_of(const Mechanism& mechanism) {
  const std::string_view page =
      mechanism.dimension == 2 ? page_template.planar : page_template.spatial;
  if (page.empty())
    throw CommandError(
        unavailable,
        "this program was built without the scripts of the page; build it where Node.js 18 "
        "or later and npm are installed and packages can be fetched");
  return page;
}

/// Puts data in the places that the template has for them.
std::string fill(std::string_view page, const PageData& data) {
  std::string result;
  for (const auto& [mark, text] :
       {std::pair<std::string_view, const std::string*>{"@DATA@", &data.json},
        {"@NUMBERS@", &data.numbers}}) {
    const std::size_t at = page.find(mark);
    result.append(page.substr(0, at)).append(*text);
    page.remove_prefix(at + mark.size());
  }
  return result.append(page);
}

[[noreturn]] void refuse_size(const std::string& source, const Model& model) {
  throw InputError(source + ": a page cannot show a mechanism of " +
                   std::to_string(model.coordinates()) + " coordinates; view a smaller one");
}

/// Returns a page that is small enough: of every instant, or else of fewer.
std::string page_of(std::string_view page, const ShownMotion& motion, const std::string& source) {
  for (int every = 1;; every *= 2) {
    std::string result = fill(page, page_data(motion, every));
    if (result.size() <= max_page) return result;
    if (motion.recording.instants().size() / static_cast<std::size_t>(every) < 16)
      refuse_size(source, motion.model);
  }
}

void view(const ViewOptions& options) {
  const Input input = load_scene(options.scene);
  const std::string_view page = template_of(input.scene.mechanism);
  OutputFile output(options.output, remove_when_interrupted);
  if (output.is_standard_output() && ::isatty(STDOUT_FILENO) == 1)
    throw CommandError(usage_error, "a page is nothing for a terminal; give --output FILE.html");
  const Model model = model_mechanism(input).model;
  if (model.coordinates() > max_coordinates) refuse_size(input.source, model);
  const TimeGrid& grid = input.scene.grid;
  const auto formulation =
      make_formulation(find_variant(formulation_id), model, {.tolerance = input.scene.tolerance});
  std::optional<bench::Progress> progress;
  if (!options.quiet) progress.emplace("instants", grid.instants, true);
  MotionRecorder recording(
      model, grid,
      std::min(max_instants, max_numbers / (3 * static_cast<std::size_t>(model.coordinates()) + 1)),
      progress ? &*progress : nullptr);
  const MonitoredSummary summary = recording.run(*formulation);
  progress.reset();
  if (recording.overflowed())
    throw CommandError(not_solved,
                       input.source + ": a number is not finite; choose another motion");
  output.write(
      page_of(page, {input.scene, model, recording, summary, formulation_id}, input.source));
  output.finish();
  const auto& flags = recording.flags();
  const auto failed = std::ranges::find(flags, Flag::Kind::failed, &Flag::kind);
  if (failed != flags.end())
    throw CommandError(not_solved, input.source + ": " + failed->text +
                                       (recording.solved() > 0
                                            ? "\ndesmo: the page shows the last position before it"
                                            : "\ndesmo: the page shows the initial estimate"));
}

}  // namespace

void add_view(CLI::App& program) {
  CLI::App* command =
      program.add_subcommand("view", "Show a scene in motion, as one page for a browser");
  const auto options = std::make_shared<ViewOptions>();
  command
      ->add_option("scene", options->scene,
                   "Scene file, - for standard input, library mechanism (its scene), or scalable "
                   "case with its units, such as truck_suspension:5")
      ->required();
  command
      ->add_option("-o,--output", options->output,
                   "Write to this file, whole or not at all, instead of standard output")
      ->check(refuse_empty);
  command->add_flag("--quiet", options->quiet, "No progress");
  command->callback([options] { view(*options); });
}

}  // namespace desmo::cli
