#include "bench/cli/solve/check_option.h"

#include <string>

#include "bench/cli/commands.h"
#include "cases/mechanism/formatted.h"

namespace desmo::cli {

namespace {

void read_check_mode(CheckOptions& options, const std::string& given) {
  const std::size_t colon = given.find(':');
  options.mode = chosen<CheckMode>("--check", std::string_view(given).substr(0, colon),
                                   {{"proof", CheckMode::proof},
                                    {"mechanism", CheckMode::mechanism},
                                    {"sample", CheckMode::sample},
                                    {"none", CheckMode::none}});
  const auto refuse = [&](const std::string& what) {
    throw CLI::ValidationError("--check", desmo::in_quotes(given) + ": " + what);
  };
  if (colon == std::string::npos) return;
  if (options.mode != CheckMode::sample) refuse("a number follows sample alone, as in sample:16");
  if (!parse_number(std::string_view(given).substr(colon + 1), options.sample) ||
      options.sample < 1)
    refuse("the number of rows is a whole number from 1 on");
}

}  // namespace

CLI::Option* add_check(CLI::App& command, CheckOptions& options) {
  return command
      .add_option_function<std::string>(
          "--check", [&options](const std::string& given) { read_check_mode(options, given); },
          "What is proven: proof, every row and every step of what is asked for (the default); "
          "mechanism, also the positions of all else; sample:N, one step over N rows, and every "
          "N-th row to the last digit (16); none, nothing")
      ->type_name("proof|mechanism|sample[:N]|none");
}

}  // namespace desmo::cli
