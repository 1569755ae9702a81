#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "cases/io/units.h"
#include "cases/mechanism/scene.h"

namespace desmo {

/// A scene, and what else its file tells.
struct SceneFile {
  Scene scene;
  DisplayUnits units;  ///< of motions: its own, or those of the mechanism where it names none
  std::vector<std::filesystem::path> files;  ///< others that were read: mechanism, tables
};

/// Reads a scene like parse_scene() (cases/io/files.h), with its units.
SceneFile parse_scene_file(std::string_view text, const std::string& file_name,
                           const std::filesystem::path& folder);

}  // namespace desmo
