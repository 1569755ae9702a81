// Input of the commands: a file, standard input, or a name.
#pragma once

#include <string>
#include <vector>

#include "bench/cli/units.h"
#include "cases/io/readers.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/modelling/modelling.h"

namespace desmo::cli {

/// Formulation where none is named. Parts without generated code are left to dense LU, whose cost
/// grows with the cube of their unknowns: blocks have the fewest. Closed forms (`explicit`) are
/// faster where there is code, but most of a row's time goes into its proof.
inline constexpr const char* default_formulation = "block_symbolic_inlined";

/// A scene. One made from a mechanism file has drivers at rest, and no instants. Commands write and
/// read numbers in `units`; the scene's own numbers are in SI units.
struct Input : ReadScene {
  std::string source;  ///< name of the input in messages
  std::string file;    ///< path of the file read, /dev/stdin for "-"; empty: no file was read
};

/// Loads a scene. Throws InputError, UnreadableFile and CommandError (unreadable_input; usage_error
/// for a number of units), naming the source. The argument is:
/// - a scene file, if it contains "/" or ".", or is none of the names below; "-" is standard input
/// - the name of a library mechanism, for its scene
/// - a scalable case with its number of units, "truck_suspension:5"
///
/// units: si replaces Input::units by metres and radians.
Input load_scene(const std::string& argument, UnitSystem units = UnitSystem::file);

/// Loads like load_scene(), but accepts mechanism files too.
Input load_mechanism(const std::string& argument);

/// Throws CommandError (usage_error) where the file `output` would replace a file that is read: the
/// scene, a file that it names, or that of the drivers' rows. drivers: its path; "-" is standard
/// input, "" none.
void protect_input(const std::string& output, const Input& input, const std::string& drivers = "");

/// Makes the model of an input. Throws InputError, naming the source.
ModellingResult model_mechanism(const Input& input, Modelling modelling = Modelling::natural);

/// Returns the outputs of the scene, in terms of its whole model. Throws InputError, naming the
/// source.
std::vector<Output> outputs_of(const Input& input, const Model& whole);

}  // namespace desmo::cli
