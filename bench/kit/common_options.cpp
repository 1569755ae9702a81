#include "bench/kit/common_options.h"

#include <iostream>
#include <vector>

namespace desmo::bench {

void add_common(bench::OptionTable& table, CommonOptions& options, const CommonHelp& help) {
  table.text("--record", "FILE", options.record, "Write the results record to this file");
  table.flag("--quick", options.quick, "A first look: " + help.quick);
  if (!help.repetitions.empty())
    table.positive("--repetitions", "N", options.repetitions,
                   "Samples of each time (" + help.repetitions + ")");
  table.text("--filter", "REGEX", options.filter,
             "Only where this regular expression is found in\n" + help.filtered);
}

bool read_options(const bench::OptionTable& table, const CommandLine& line,
                  std::vector<std::string>* words) {
  std::vector<char*> rest = table.take(line.arguments);
  if (table.asks_for_help()) {
    std::cout << table.help();
    return false;
  }
  if (words)
    std::erase_if(rest, [&](const char* argument) {
      if (*argument == '-') return false;
      words->emplace_back(argument);
      return true;
    });
  bench::require_none(rest);
  return true;
}

}  // namespace desmo::bench
