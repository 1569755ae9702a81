#include "bench/experiments/options.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <stdexcept>

namespace desmo::bench {

void add_common(CLI::App& parser, CommonOptions& options, const CommonHelp& help) {
  parser.add_option("--record", options.record, "Write the results record to this file")
      ->type_name("FILE");
  parser.add_flag("--quick", options.quick, "A first look: " + help.quick);
  if (!help.repetitions.empty())
    parser
        .add_option("--repetitions", options.repetitions,
                    "Samples of each time (" + help.repetitions + ")")
        ->type_name("N")
        ->check(refuse_not_positive);
  parser
      .add_option("--filter", options.filter,
                  "Only where this regular expression is found in " + help.filtered)
      ->type_name("REGEX");
}

std::string refuse_not_positive(const std::string& text) {
  const double value = std::strtod(text.c_str(), nullptr);
  return value > 0 && std::isfinite(value) ? "" : "'" + text + "' is not a positive number";
}

bool read(CLI::App& parser, const std::vector<std::string>& arguments) {
  std::vector<std::string> last_first(arguments.rbegin(), arguments.rend());
  try {
    parser.parse(last_first);
    return true;
  } catch (const CLI::Success& asked) {  // --help
    parser.exit(asked, std::cout);
    return false;
  } catch (const CLI::ParseError& error) {
    throw std::invalid_argument(error.what());
  }
}

std::string beside_this_program(const std::string& name) {
  return (std::filesystem::read_symlink("/proc/self/exe").parent_path() / name).string();
}

}  // namespace desmo::bench
