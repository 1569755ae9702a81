// Input of the commands: a file, standard input, or a name.
#pragma once

#include <string>

#include "cases/mechanism/scene.h"
#include "formulations/modelling/modelling.h"

namespace desmo::cli {

struct Input {
  std::string source;  ///< for messages
  bool is_file;        ///< it was read from a file named `source`
  Scene scene;         ///< for a mechanism file: drivers at rest, no instants
};

/// Loads a scene. Throws InputError and Error (unreadable_input), naming the source. The argument
/// is:
/// - a scene file, if it contains "/" or "."; "-" is standard input
/// - the name of a library mechanism, for its scene
/// - a scalable case with its number of units, "truck_suspension:5"
Input load_scene(const std::string& argument);

/// Loads like load_scene(), but accepts mechanism files too.
Input load_mechanism(const std::string& argument);

/// Makes the model of an input. Throws InputError, naming the source.
ModellingResult model_mechanism(const Input& input);

}  // namespace desmo::cli
