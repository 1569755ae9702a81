// desmo inspect: the structure of a mechanism.
#include <unistd.h>

#include <cstdio>
#include <memory>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/inspect/inspection.h"
#include "bench/cli/interruption.h"
#include "cases/io/new_files.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

struct InspectOptions {
  std::string mechanism;
  std::string diagram;
  bool json = false;

  bool draws() const { return diagram.ends_with(".svg"); }
  bool diagram_only() const { return diagram == "-"; }
};

void check(const InspectOptions& options) {
  const std::string& file = options.diagram;
  if (!file.empty() && !options.draws() && !options.diagram_only() && !file.ends_with(".dot"))
    throw CommandError(usage_error,
                       "--diagram " + desmo::in_quotes(file) +
                           ": the kind of file cannot be told; end its name in .svg or .dot");
  if (options.json && options.diagram_only())
    throw CommandError(usage_error,
                       "--json and --diagram - both need standard output; write the diagram "
                       "to a file");
}

/// Lets the dot program of Graphviz draw a graph as SVG to `output`.
void draw_svg(const std::string& graph, const OutputFile& output) {
  const std::string command = "exec dot -Tsvg >/proc/" + std::to_string(::getpid()) + "/fd/" +
                              std::to_string(output.descriptor());
  std::FILE* const dot = ::popen(command.c_str(), "w");
  const bool is_read = dot && std::fputs(graph.c_str(), dot) >= 0;
  if (!dot || ::pclose(dot) != 0 || !is_read)
    throw CommandError(
        unavailable,
        "the program 'dot' cannot be run, or has failed; install Graphviz (Debian: apt-get "
        "install graphviz), or let --diagram write a .dot file");
}

void write_diagram(const std::string& dot, const InspectOptions& options) {
  OutputFile output(options.diagram, remove_when_interrupted);
  if (options.draws())
    draw_svg(dot, output);
  else
    output.write(dot);
  output.finish();
}

void run(const InspectOptions& options) {
  check(options);
  const Inspection inspection = inspect(load_mechanism(options.mechanism));
  if (!options.diagram.empty()) write_diagram(to_dot(inspection), options);
  if (!options.diagram_only())
    write_standard_output(options.json ? to_json(inspection) : to_text(inspection));
}

}  // namespace

void add_inspect(CLI::App& program) {
  CLI::App* command = program.add_subcommand(
      "inspect", "Structural groups, coordinates and equations of a mechanism");
  const auto options = std::make_shared<InspectOptions>();
  command
      ->add_option("mechanism", options->mechanism,
                   "Mechanism or scene file, - for standard input, library mechanism, or scalable "
                   "case with its units, such as truck_suspension:5")
      ->required();
  command->add_flag("--json", options->json, "As JSON, with equations and unknowns by name");
  command
      ->add_option("--diagram", options->diagram,
                   "Write the structural diagram: FILE.svg (drawn by Graphviz), FILE.dot, or - "
                   "for DOT on standard output and nothing else")
      ->check(refuse_empty);
  command->callback([options] { run(*options); });
}

}  // namespace desmo::cli
