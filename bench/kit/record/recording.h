#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "bench/kit/record/new_file.h"
#include "bench/kit/record/record.h"

namespace desmo::bench {

/// A record under way: begun before anything is measured, so that an unusable path is known then,
/// and written once all is.
class Recording {
 public:
  /// Notes date and load, and takes the file (see NewFile). Throws std::runtime_error, naming the
  /// path, and std::invalid_argument for an empty one.
  Recording(const std::string& path, const std::string& command);

  /// Notes the load and writes lists (see record_text) to the file, once. Throws
  /// std::runtime_error, naming the path.
  void write(const TimeGrid& grid, const nlohmann::ordered_json& lists);

 private:
  NewFile file_;
  Run run_;
};

}  // namespace desmo::bench
