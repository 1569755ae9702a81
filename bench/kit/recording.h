#pragma once

#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/kit/new_file.h"
#include "bench/kit/record.h"

namespace CLI {
class App;
}

namespace desmo::suite {

/// A record under way: begun before anything is measured, so that an unusable path is known then,
/// and written once all is.
class Recording {
 public:
  /// Notes date and load, and takes the file (see NewFile). Throws std::runtime_error, naming the
  /// path.
  Recording(const std::string& path, const std::string& command);

  /// Notes the load and writes lists (see record_text) to the file, once. Throws
  /// std::runtime_error, naming the path.
  void write(const TimeGrid& grid, const nlohmann::ordered_json& lists);

 private:
  NewFile file_;
  Run run_;
};

/// The rest of main() in a program that measures into a record: reads the command line, runs, and
/// says on standard error, after the program's name, what went wrong. Returns the exit code: 0; 1
/// where run() says false, for something that was measured is wrong; 64 for a mistake in the
/// command line, std::regex_error and std::invalid_argument among them; 74 for any other exception.
int record_main(CLI::App& program, int argc, char** argv, const std::function<bool()>& run);

}  // namespace desmo::suite
