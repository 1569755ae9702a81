#include "bench/kit/recording.h"

#include <CLI/CLI.hpp>
#include <exception>
#include <iostream>
#include <nlohmann/json.hpp>
#include <regex>
#include <stdexcept>

#include "bench/kit/environment.h"

namespace desmo::suite {

namespace {

constexpr int usage = 64, not_written = 74;

}  // namespace

Recording::Recording(const std::string& path, const std::string& command)
    : file_(path), run_{utc_now(), command, load_averages(), {}} {}

void Recording::write(const TimeGrid& grid, const nlohmann::ordered_json& lists) {
  run_.load_after = load_averages();
  file_.write(record_text(run_, grid, lists));
}

int record_main(CLI::App& program, int argc, char** argv, const std::function<bool()>& run) {
  const auto failed = [&](const std::string& message, int code) {
    std::cerr << program.get_name() << ": " << message << '\n';
    return code;
  };
  try {
    program.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return program.exit(error) == 0 ? 0 : usage;
  }
  try {
    return run() ? 0 : 1;
  } catch (const std::regex_error& error) {
    return failed(std::string("not a regular expression: ") + error.what(), usage);
  } catch (const std::invalid_argument& error) {
    return failed(error.what(), usage);
  } catch (const std::exception& error) {
    return failed(error.what(), not_written);
  }
}

}  // namespace desmo::suite
