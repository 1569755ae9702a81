// desmo: structure and kinematics of mechanisms from the command line.
#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "bench/cli/commands.h"
#include "bench/cli/errors.h"
#include "bench/cli/interruption.h"
#include "cases/io/new_files.h"
#include "cases/mechanism/names.h"

namespace {

using namespace desmo;

/// Opens /dev/null for each standard stream that the caller has closed, so that no file opened
/// later takes its place.
void occupy_standard_streams() {
  int file = ::open("/dev/null", O_RDONLY);
  while (file >= 0 && file <= STDERR_FILENO) file = ::dup(file);
  if (file > STDERR_FILENO) ::close(file);
}

void require_known_command(const CLI::App& program, int argc, char** argv) {
  if (argc < 2 || argv[1][0] == '-') return;
  std::vector<std::string> names;
  for (const CLI::App* command : program.get_subcommands({})) names.push_back(command->get_name());
  if (std::ranges::find(names, argv[1]) != names.end()) return;
  throw cli::CommandError(
      cli::usage_error,
      unknown_name("command", argv[1], std::vector<std::string_view>(names.begin(), names.end())));
}

/// Returns the subcommand that was given, or the program.
CLI::App& given_command(CLI::App& program) {
  const std::vector<CLI::App*> given = program.get_subcommands();
  return given.empty() ? program : *given.front();
}

/// Returns "desmo solve"; "desmo" for the program.
std::string full_name(const CLI::App& command) {
  return (command.get_parent() ? "desmo " : "") + command.get_name();
}

std::string hint(const CLI::App& command) {
  return "; '" + full_name(command) + " --help' shows what there is";
}

/// Throws CommandError (usage_error) for words that a command does not take: names the first
/// unknown option or, where there is none, the first word too many.
[[noreturn]] void refuse_extras(CLI::App& program) {
  const CLI::App& command = given_command(program);
  const std::string name = full_name(command);
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& s : option->get_snames()) options.push_back("-" + s);
    for (const std::string& l : option->get_lnames()) options.push_back("--" + l);
  }
  const std::vector<std::string> extras = program.remaining(true);
  const auto unknown = std::ranges::find_if(
      extras, [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
  if (unknown == extras.end())
    throw cli::CommandError(
        cli::usage_error,
        in_quotes(extras.front()) + ": " + name + " takes no further argument; leave it out" +
            (command.get_option_no_throw("-o") ? ", or write -o before the name of an output"
                                               : "") +
            hint(command));
  const std::string option = unknown->substr(0, unknown->find('='));
  const std::vector<std::string_view> near =
      nearest_names(option, std::vector<std::string_view>(options.begin(), options.end()));
  const std::string meant = near.empty() ? "" : "; did you mean " + joined(near, in_quotes) + "?";
  throw cli::CommandError(cli::usage_error,
                          name + " has no option " + in_quotes(option) + meant + hint(command));
}

void run(int argc, char** argv) {
  CLI::App program{"Kinematics of multibody systems by structural groups", "desmo"};
  program.set_version_flag("--version", "desmo " DESMO_VERSION);
  program.require_subcommand(1);
  for (cli::AddCommand* const add : cli::commands) add(program);
  program.footer(
      "Examples (more with desmo COMMAND --help):\n"
      "  desmo show slider_crank > mine.json\n"
      "  desmo inspect mine.json\n"
      "  desmo solve slider_crank -o motion.csv\n"
      "  desmo view slider_crank -o motion.html\n"
      "Exit codes: 0 done, 1 the mechanism cannot be solved, 64 usage, 65 a file says something\n"
      "wrong, 66 a file cannot be read, 69 the page of view was not built, 70 an internal error,\n"
      "74 output cannot be written, 129, 130, 143 interrupted, 141 standard output was closed");
  require_known_command(program, argc, argv);
  try {
    program.parse(argc, argv);
  } catch (const CLI::Success& wanted) {  // --help, --version
    std::ostringstream text, unused;
    program.exit(wanted, text, unused);
    write_standard_output(text.str());
  } catch (const CLI::ExtrasError&) {
    refuse_extras(program);
  } catch (const CLI::ParseError& error) {
    throw cli::CommandError(cli::usage_error,
                            printable(error.what(), 300) + hint(given_command(program)));
  }
}

}  // namespace

int main(int argc, char** argv) {
  try {
    occupy_standard_streams();
    cli::handle_signals();
    run(argc, argv);
    return cli::success;
  } catch (...) {
    return cli::report_current_exception();
  }
}
