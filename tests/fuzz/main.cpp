// desmo_fuzz: spoilt mechanism and scene files, each tried the whole way from text to solution.
#include <charconv>
#include <cstdio>
#include <cstring>
#include <exception>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "tests/fuzz/campaign.h"

namespace desmo::fuzz {
namespace {

constexpr const char* usage =
    "desmo_fuzz [--inputs N] [--seed S] [--first I] [--save FOLDER] [--corpus FOLDER]\n"
    "desmo_fuzz --show I [--seed S]     writes input I to standard output\n"
    "desmo_fuzz FILE...                 tries files with every formulation\n";

struct Command {
  Options options;
  long show = -1;
  std::vector<std::string> files;
};

template <class Number>
Number number(std::string_view option, std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || value < 0)
    throw std::invalid_argument(std::string(option) + ": '" + std::string(text) +
                                "' is no number of inputs or seed");
  return value;
}

Command read_command(const std::vector<std::string_view>& arguments) {
  Command command;
  command.options.corpus = DESMO_SOURCE_DIR "/tests/fuzz/corpus";
  command.options.progress = true;
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const std::string_view option = arguments[i];
    if (!option.starts_with("--")) {
      command.files.emplace_back(option);
      continue;
    }
    if (++i == arguments.size())
      throw std::invalid_argument(std::string(option) + ": no value, or no such option");
    const std::string_view value = arguments[i];
    if (option == "--inputs")
      command.options.inputs = number<long>(option, value);
    else if (option == "--seed")
      command.options.seed = number<std::uint64_t>(option, value);
    else if (option == "--first")
      command.options.first = number<long>(option, value);
    else if (option == "--show")
      command.show = number<long>(option, value);
    else if (option == "--save")
      command.options.save = value;
    else if (option == "--corpus")
      command.options.corpus = value;
    else
      throw std::invalid_argument(std::string(option) + ": no such option");
  }
  return command;
}

bool try_file(const std::string& name, const Options& options) {
  std::ifstream stream(name, std::ios::binary);
  if (!stream) throw std::invalid_argument(name + ": cannot be read");
  const std::string text{std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
  const Campaign campaign = replay(text, options.corpus);
  std::printf("%s\n%s", name.c_str(), report(campaign).c_str());
  return campaign.findings.empty();
}

int run_command(const Command& command) {
  const Options& o = command.options;
  if (command.show >= 0) {
    const std::string text = make_input(load_corpus(o.corpus), o.seed, command.show);
    std::fwrite(text.data(), 1, text.size(), stdout);
    return 0;
  }
  if (!command.files.empty()) {
    bool fine = true;
    for (const std::string& file : command.files) fine = try_file(file, o) && fine;
    return fine ? 0 : 1;
  }
  const Campaign campaign = run(o);
  std::printf("seed %llu, inputs %ld to %ld\n%s", static_cast<unsigned long long>(o.seed), o.first,
              o.first + o.inputs - 1, report(campaign).c_str());
  return campaign.findings.empty() ? 0 : 1;
}

}  // namespace
}  // namespace desmo::fuzz

int main(int argc, char** argv) {
  constexpr int usage_error = 64;
  try {
    return desmo::fuzz::run_command(desmo::fuzz::read_command({argv + 1, argv + argc}));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "desmo_fuzz: %s\n%s", error.what(), desmo::fuzz::usage);
    return usage_error;
  }
}
