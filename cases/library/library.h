#pragma once

#include <span>
#include <string_view>

namespace desmo {

/// A mechanism of cases/library, embedded in the program.
struct LibraryMechanism {
  std::string_view name;       ///< file name without extension
  std::string_view mechanism;  ///< text of <name>.json
  std::string_view scene;      ///< text of <name>.scene.json
};

/// Returns all mechanisms of the library, in alphabetical order.
std::span<const LibraryMechanism> library();

/// Returns the mechanism of that name; null when there is none.
const LibraryMechanism* find_library(std::string_view name);

/// A scene of cases/requests: a request for the truck suspension, with which the suite measures the
/// cost of requests.
struct RequestScene {
  std::string_view name;   ///< file name without extensions
  std::string_view scene;  ///< text of <name>.scene.json
};

/// Returns all request scenes, in the order of the report.
std::span<const RequestScene> request_scenes();

}  // namespace desmo
