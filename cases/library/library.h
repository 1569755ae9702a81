#pragma once

#include <span>
#include <string_view>

namespace desmo {

/// A mechanism of cases/library, carried by the program itself.
struct LibraryMechanism {
  std::string_view name;
  std::string_view mechanism;  ///< text of <name>.json
  std::string_view scene;      ///< text of <name>.scene.json
};

/// In alphabetical order.
std::span<const LibraryMechanism> library();

/// Null when there is none of that name.
const LibraryMechanism* find_library(std::string_view name);

/// A scene of cases/requests: what is asked of the truck suspension where the suite measures what a
/// request costs.
struct RequestScene {
  std::string_view name;
  std::string_view scene;  ///< text of <name>.scene.json
};

/// In the order of the report.
std::span<const RequestScene> request_scenes();

}  // namespace desmo
