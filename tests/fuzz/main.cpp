// desmo_fuzz: spoilt mechanism and scene files, each tried the whole way from text to solution.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <optional>
#include <string>
#include <vector>

#include "cases/io/text_file.h"
#include "tests/fuzz/campaign.h"

namespace desmo::fuzz {
namespace {

bool tell(const Campaign& campaign, const std::string& name) {
  std::printf("%s\n%s", name.c_str(), report(campaign).c_str());
  return campaign.findings.empty();
}

int run_command(CLI::App& parser, int argc, char** argv) {
  Options options;
  options.corpus = DESMO_SOURCE_DIR "/tests/fuzz/corpus";
  options.progress = true;
  std::optional<long> shown;
  std::vector<std::string> files;
  const CLI::Range number(0L, 1'000'000'000L);
  parser.add_option("FILE", files, "Tries files with every formulation")->check(CLI::ExistingFile);
  parser.add_option("--inputs", options.inputs, "Number of inputs")->check(number);
  parser.add_option("--first", options.first, "The first of them")->check(number);
  parser.add_option("--seed", options.seed, "Seed of their random numbers");
  parser.add_option("--show", shown, "Writes that input to standard output")->check(number);
  parser.add_option("--save", options.save, "Folder for inputs that cause findings");
  parser.parse(argc, argv);
  if (shown) {
    const std::string text = make_input(load_corpus(options.corpus), options.seed, *shown);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return 0;
  }
  bool fine = true;
  for (const std::string& file : files)
    fine = tell(replay(read_text(file), options.corpus), file) && fine;
  if (files.empty())
    fine = tell(run(options), "seed " + std::to_string(options.seed) + ", inputs " +
                                  std::to_string(options.first) + " to " +
                                  std::to_string(options.first + options.inputs - 1));
  return fine ? 0 : 1;
}

}  // namespace
}  // namespace desmo::fuzz

int main(int argc, char** argv) {
  constexpr int usage_error = 64;
  CLI::App parser("desmo_fuzz: spoilt mechanism and scene files");
  try {
    return desmo::fuzz::run_command(parser, argc, argv);
  } catch (const CLI::ParseError& error) {
    return parser.exit(error) == 0 ? 0 : usage_error;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "desmo_fuzz: %s\n", error.what());
    return usage_error;
  }
}
