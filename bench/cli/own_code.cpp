#include "bench/cli/own_code.h"

#include <chrono>
#include <cstdio>
#include <vector>

#include "bench/cli/commands.h"
#include "bench/cli/text.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"

namespace desmo::cli {
namespace {

/// Returns a note on the code generated for a formulation and the time it took, or on why there is
/// none. It is empty when the program's own code sufficed.
std::string note_on(const GenerationOutcome& own) {
  std::string note;
  if (own.parts_too_large > 0)
    note = "note: " + count(own.parts_too_large, "part") + " too large to generate code for\n";
  if (own.types.empty())
    return note + (own.problem.empty() ? "" : "note: " + printable(own.problem, 600) + "\n");
  std::vector<std::string> types;
  for (const TypeUse& t : own.types)
    types.push_back(printable(t.group) + " (" + count(t.unknowns, "unknown") +
                    (t.parts > 1 ? ", " + count(t.parts, "part") : "") + ")");
  const std::string of = " for " + enumerate(types, 8) + ": ";
  if (!own.problem.empty()) return note + "note: no code" + of + printable(own.problem, 600) + "\n";
  return note + "note: code" + of +
         (own.compiled
              ? "compiled by " + own.compiler + formatted(" in %.2f s", own.seconds_compiling)
              : "from " + printable(own.folder, 300)) +
         formatted(" (%.2f s in all)\n", own.seconds);
}

}  // namespace

void add_options(CLI::App& command, GenerationOptions& wanted) {
  command.add_flag("--no-compile", wanted.none,
                   "Generate and load no code: parts for which the program brings none are "
                   "evaluated automatically");
  command
      .add_option("--compile-limit", wanted.compile_limit,
                  "Seconds that a compiler may take; 60 by default")
      ->check(CLI::Range(0.001, 86400.0))
      ->check(require_positive);  // else NaN, which CLI::Range accepts, would pass
}

void add_missing_code(KernelTable& table, const Configuration& formulation, const Model& model,
                      const TimeGrid& grid, const GenerationOptions& wanted, bool quiet) {
  if (wanted.none) return;
  const std::chrono::duration<double> limit(wanted.compile_limit);
  const GenerationOutcome own =
      load::add_generated_code(table, *formulation.variant, formulation.settings, model, grid,
                               std::chrono::ceil<std::chrono::milliseconds>(limit));
  if (!quiet) std::fputs(note_on(own).c_str(), stderr);
}

}  // namespace desmo::cli
