// desmo show: a library mechanism as JSON, as a starting point.

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "cases/io/new_files.h"
#include "cases/library/library.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

struct ShowOptions {
  std::string name;
  bool scene = false;
};

void show(const ShowOptions& options) {
  const LibraryMechanism* const found = find_library(options.name);
  if (!found)
    throw CommandError(usage_error,
                       unknown_name("library mechanism", options.name, names_of(library())));
  write_standard_output(options.scene ? found->scene : found->mechanism);
}

}  // namespace

void add_show(CLI::App& program) {
  const auto [command, options] =
      add_command(program, "show", "Print a library mechanism, or its scene, as JSON", show);
  command.add_option("name", options.name, "Library mechanism (see desmo list)")->required();
  command.add_flag("--scene", options.scene, "Print its scene instead");
  command.footer(
      "Examples:\n"
      "  desmo show slider_crank > mine.json\n"
      "  desmo show slider_crank --scene > mine.scene.json");
}

}  // namespace desmo::cli
