#include "bench/cli/input.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include "bench/cli/errors.h"
#include "cases/generators/cases.h"
#include "cases/io/text_file.h"
#include "cases/library/library.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/modelling/contradiction_error.h"

namespace desmo::cli {
namespace {

constexpr const char* standard_input = "/dev/stdin";

std::string read_standard_input(const std::string& source) {
  std::string text;
  std::array<char, 1 << 16> buffer;
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), stdin)) {
    text.append(buffer.data(), size);
    if (text.size() > max_file)
      throw CommandError(unreadable_input, source + ": is larger than 64 MiB; divide it");
  }
  if (std::ferror(stdin))
    throw CommandError(unreadable_input, source + ": cannot be read (" + std::strerror(errno) +
                                             "); send a scene or give a file");
  return text;
}

/// Returns a scene of the mechanism with its drivers at rest: a model needs some motion of the
/// drivers, even where no output depends on it.
Scene at_rest(Mechanism mechanism) {
  Scene scene;
  scene.name = mechanism.name;
  for (const Mechanism::Coordinate& c : mechanism.coordinates)
    if (c.driven) scene.motions.push_back(Polynomial{{c.estimate.value_or(0)}});
  scene.mechanism = std::move(mechanism);
  return scene;
}

ReadScene from_text(const std::string& text, const std::string& source,
                    const std::filesystem::path& folder, bool mechanism_will_do) {
  const JsonDocument document(text, source);
  const JsonValue root = document.root();
  const auto format = root.find("format");
  if (!format || !format->is_string() || format->text() != "desmo-mechanism")
    return scene_from(root, folder);
  if (!mechanism_will_do)
    format->complain(
        "a mechanism says nothing of motion and time; give a scene that names it (an example: "
        "desmo show slider_crank --scene)");
  NamedFiles files{folder};
  ReadMechanism read = mechanism_from(root, files);
  return {at_rest(std::move(read.mechanism)), std::move(read.units), std::move(files.read)};
}

Input from_file(const std::string& name, bool mechanism_will_do) {
  const std::string source = printable(name, 300);
  const std::string text = read_named_text(name);
  const std::filesystem::path folder = std::filesystem::path(name).parent_path();
  return {from_text(text, source, folder, mechanism_will_do), source, name};
}

/// Returns the scene that "truck_suspension:5" names; none when no case has the name before the
/// colon. Throws CommandError (usage_error) where a case has it, but the number of units is missing
/// or wrong.
std::optional<Scene> scalable_case(const std::string& argument) {
  const std::size_t colon = argument.find(':');
  for (const Case& c : cases()) {
    if (argument.substr(0, colon) != c.name) continue;
    int units = 0;
    if (colon == std::string::npos ||
        !parse_number(std::string_view(argument).substr(colon + 1), units))
      throw CommandError(usage_error, desmo::in_quotes(argument) + ": has no number of " +
                                          std::string(c.unit_name) + "; write " +
                                          std::string(c.name) + ":5");
    try {
      return c.with_units(units);
    } catch (const std::invalid_argument& wrong) {
      throw CommandError(usage_error, desmo::in_quotes(argument) + ": " + wrong.what());
    }
  }
  return std::nullopt;
}

Input load(const std::string& argument, bool mechanism_will_do) {
  if (argument == "-") {
    const std::string source = "standard input";
    return {from_text(read_standard_input(source), source, {}, mechanism_will_do), source,
            standard_input};
  }
  if (argument.find_first_of("/.") != std::string::npos)
    return from_file(argument, mechanism_will_do);
  if (const LibraryMechanism* const found = find_library(argument)) {
    const JsonDocument document(found->scene, "library/" + argument + ".scene.json");
    return {scene_from(document.root(), {}), argument, ""};
  }
  if (std::optional<Scene> scene = scalable_case(argument)) {
    DisplayUnits units{.length = {scene->mechanism.length_unit}};
    return {{std::move(*scene), std::move(units)}, argument, ""};
  }
  std::error_code ignored;
  if (std::filesystem::exists(argument, ignored)) return from_file(argument, mechanism_will_do);
  std::vector<std::string_view> names = names_of(library());
  for (const Case& c : cases()) names.push_back(c.name);
  throw CommandError(unreadable_input, desmo::in_quotes(argument) +
                                           ": there is no such file, library mechanism or " +
                                           "scalable case; " + suggestion(argument, names));
}

}  // namespace

Input load_scene(const std::string& argument, UnitSystem system) {
  Input input = load(argument, false);
  if (system == UnitSystem::si) input.units = input.units.base();
  return input;
}

Input load_mechanism(const std::string& argument) { return load(argument, true); }

void protect_input(const std::string& output, const Input& input, const std::string& drivers) {
  namespace fs = std::filesystem;
  std::error_code ignored;
  if (!fs::is_regular_file(output, ignored)) return;
  const auto protect = [&](const std::string& file, const char* what) {
    if (fs::equivalent(output, file, ignored))
      throw CommandError(usage_error, "--output " + desmo::in_quotes(output) + ": this is " + what +
                                          ", which is read; give another file");
  };
  protect(input.file, "the scene");
  for (const fs::path& named : input.files) protect(named.string(), "a file that the scene names");
  protect(drivers == "-" ? std::string(standard_input) : drivers, "the file of the drivers");
}

ModellingResult model_mechanism(const Input& input, Modelling modelling) {
  try {
    return desmo::model_mechanism(input.scene.mechanism, input.scene.motions, modelling);
  } catch (const ContradictionError& error) {
    throw InputError(input.source + ": " + error.text(input.units));
  } catch (const std::invalid_argument& error) {
    throw InputError(input.source + ": " + error.what());
  }
}

std::vector<Output> outputs_of(const Input& input, const Model& whole) {
  try {
    return desmo::outputs_of(input.scene, whole);
  } catch (const std::invalid_argument& error) {
    throw InputError(input.source + ": " + error.what());
  }
}

}  // namespace desmo::cli
