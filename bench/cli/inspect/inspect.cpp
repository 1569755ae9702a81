// desmo inspect: the structure of a mechanism.
#include <cstdio>
#include <nlohmann/json.hpp>
#include <string>

#include "bench/cli/commands.h"
#include "bench/cli/drawing_notes.h"
#include "bench/cli/inspect/inspection.h"
#include "cases/io/new_files.h"

namespace desmo::cli {
namespace {

struct InspectOptions {
  std::string mechanism;
  bool json = false;
  Modelling coordinates = Modelling::natural;
};

void run(const InspectOptions& options) {
  const Input input = load_mechanism(options.mechanism);
  const ModellingResult modelled = model_mechanism(input, options.coordinates);
  const nlohmann::ordered_json structure = inspect(input, modelled);
  if (options.coordinates == Modelling::natural)
    std::fputs(note_on_drawing(input.scene.mechanism, modelled.model, input.units).c_str(), stderr);
  write_standard_output(options.json ? structure.dump(1) + "\n" : inspection_text(structure));
}

}  // namespace

void add_inspect(CLI::App& program) {
  const auto [command, options] = add_command(
      program, "inspect", "Structural groups, coordinates and equations of a mechanism", run);
  command
      .add_option("mechanism", options.mechanism,
                  "Mechanism or scene file, - for standard input, library mechanism, or scalable "
                  "case with its units, such as truck_suspension:5")
      ->required();
  Choices<Modelling> kinds;
  for (const Modelling kind : modelling_kinds) kinds.emplace_back(name_of(kind), kind);
  add_choice(command, "--coordinates", options.coordinates, kinds,
             "natural (default), basis, reference or relative: the tree, its variables, the joints "
             "that are cut, and what each group solves for");
  command.add_flag("--json", options.json, "As JSON, with equations and unknowns by name");
  command.footer(
      "Examples:\n"
      "  desmo inspect slider_crank\n"
      "  desmo inspect mine.json --json\n"
      "  desmo inspect truck_suspension:1 --coordinates relative");
}

}  // namespace desmo::cli
