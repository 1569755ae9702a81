// What the commands work on: a file, standard input, or a name.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/modelling/modelling.h"

namespace desmo::cli {

struct Input {
  std::string source;  ///< for messages
  bool is_file;        ///< it was read from a file of that name
  Scene scene;         ///< of a mechanism file: its drivers rest and there are no instants
};

/// A scene file, "-" for one on standard input, the name of a library mechanism (its scene), or a
/// scalable case with its units, "truck_suspension:5". What has a "/" or a "." in it is a file.
/// Throws InputError and Error (unreadable_input), naming the source.
Input load_scene(const std::string& argument);

/// The same, and mechanism files too.
Input load_mechanism(const std::string& argument);

/// Models it. Throws InputError, naming the source.
ModellingResult model_mechanism(const Input& input);

/// Names of the library, in alphabetical order.
std::vector<std::string_view> library_names();

}  // namespace desmo::cli
