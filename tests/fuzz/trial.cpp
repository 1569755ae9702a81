#include "tests/fuzz/trial.h"

#include <cxxabi.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <typeinfo>

#include "bench/kit/variant_costs.h"
#include "cases/io/files.h"
#include "cases/mechanism/names.h"
#include "formulations/modelling/modelling.h"
#include "formulations/planning/plan.h"
#include "formulations/runtime/unavailable.h"
#include "formulations/runtime/wanted_types.h"
#include "tests/fuzz/tree.h"

namespace desmo::fuzz {
namespace {

constexpr int max_instants = 5;
constexpr int max_dense = 400;  // coordinates that a dense global solve is worth
constexpr const char* file_name = "fuzz.json";

std::string type_name(const std::exception& error) {
  int status = 0;
  const std::unique_ptr<char, void (*)(void*)> name(
      abi::__cxa_demangle(typeid(error).name(), nullptr, nullptr, &status), std::free);
  return name ? name.get() : typeid(error).name();
}

// Names and numbers differ from input to input where the cause is one.
std::string kind_of(std::string message) {
  std::string kind;
  for (std::size_t i = 0; i < message.size() && kind.size() < 120; ++i) {
    const char c = message[i];
    if (c >= '0' && c <= '9') {
      if (kind.empty() || kind.back() != '#') kind += '#';
    } else if (c == '\'') {
      const std::size_t end = message.find('\'', i + 1);
      kind += "'…'";
      if (end == message.npos) break;
      i = end;
    } else {
      kind += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
  }
  return kind;
}

/// What a terminal may be sent: one line of UTF-8 that is not endless.
void check_message(const std::string& message, const std::string& stage) {
  constexpr std::size_t max_message = 1000;
  if (message.empty()) throw Finding(stage + ": an empty message", "");
  if (message.size() > max_message)
    throw Finding(stage + ": a message that is too long: " + kind_of(message.substr(0, 200)),
                  std::to_string(message.size()) + " bytes: " + message.substr(0, 300));
  // printable() changes nothing in what is fit for a terminal.
  if (printable(message, max_message) != message)
    throw Finding(stage + ": characters that are not fit for a terminal", message);
}

void check_refusal(const std::string& message, const std::string& stage,
                   const std::filesystem::path& folder) {
  check_message(message, stage);
  const bool names_file = message.starts_with(std::string(file_name) + ": ") ||
                          message.starts_with(folder.string() + "/");
  if (!names_file) throw Finding(stage + ": a message without the file's name", message);
  if (message.find("; ") == message.npos && message.find('?') == message.npos)
    throw Finding(stage + ": a message without a remedy: " + kind_of(message), message);
}

/// Calls f. What it may throw is the end of this input, with an outcome; all else is a finding.
template <class Allowed, class F>
bool passes(const std::string& stage, const std::filesystem::path& folder, F f) {
  try {
    f();
    return true;
  } catch (const Finding&) {
    throw;
  } catch (const std::exception& error) {
    if constexpr (std::is_same_v<Allowed, InputError>) {
      if (dynamic_cast<const InputError*>(&error)) {
        check_refusal(error.what(), stage, folder);
        return false;
      }
    } else if constexpr (!std::is_void_v<Allowed>) {
      if (dynamic_cast<const Allowed*>(&error)) {
        check_message(error.what(), stage);
        return false;
      }
    }
    throw Finding(stage + ": " + type_name(error) + ": " + kind_of(error.what()), error.what());
  }
}

bool names_scene(std::string_view text) { return text.find("\"desmo-scene\"") != text.npos; }

/// Equal but for the rounding of directions, which are scaled to length 1 whenever they are read.
bool agree(const Tree& a, const Tree& b) {
  constexpr double rounding = 1e-14;
  if (a.kind != b.kind || a.key != b.key || a.children.size() != b.children.size()) return false;
  for (std::size_t i = 0; i < a.children.size(); ++i)
    if (!agree(a.children[i], b.children[i])) return false;
  if (a.text == b.text) return true;
  return a.is_number() && b.is_number() &&
         std::abs(a.number() - b.number()) <= rounding * std::max(1.0, std::abs(a.number()));
}

/// What is written of a mechanism is the same mechanism.
void check_writer(const Mechanism& mechanism) {
  constexpr std::size_t largest = 200;  // points of a mechanism that is worth the time
  if (mechanism.points.size() > largest) return;
  const std::string once = write_mechanism(mechanism);
  std::string twice;
  try {
    twice = write_mechanism(parse_mechanism(once, "written.json"));
  } catch (const InputError& error) {
    throw Finding(std::string("writer: is not read again: ") + kind_of(error.what()), error.what());
  }
  if (!agree(parse_tree(once), parse_tree(twice)))
    throw Finding("writer: differs when read and written again", once);
}

bool all_finite(std::span<const double> values) {
  return std::ranges::all_of(values, [](double x) { return std::isfinite(x); });
}

void check_delivered(const Plan& plan, const Formulation& f, double time) {
  for (const Output& asked : plan.outputs) {
    const Entity& e = plan.model.entities.at(asked.entity);
    if (e.fixed) continue;
    const std::span<const double> found[] = {f.q(), f.qd(), f.qdd()};
    for (int level = 0; level <= static_cast<int>(asked.level); ++level)
      if (!all_finite(found[level].subspan(e.first, e.size)))
        throw Finding(
            "solution: success with a number that is not finite, level " + std::to_string(level),
            "'" + e.name + "' at " + std::to_string(time) + " s");
  }
}

void check_residual(const Summary& s, double tolerance) {
  constexpr double rounding = 1 + 1e-12;
  if (!(s.residual <= tolerance * rounding))
    throw Finding("solution: success with a residual beyond the tolerance",
                  std::to_string(s.residual) + " > " + std::to_string(tolerance));
}

/// A mechanism file says nothing of motion: its drivers rest where they are measured.
Scene at_rest(Mechanism mechanism) {
  Scene scene;
  scene.name = mechanism.name;
  for (const Mechanism::Coordinate& c : mechanism.coordinates)
    if (c.driven) scene.motions.push_back(Polynomial{{c.estimate.value_or(0)}});
  scene.grid = {0, 0.1, max_instants};
  scene.mechanism = std::move(mechanism);
  return scene;
}

void rest_where_measured(Model& mechanism) {
  for (Driver& driver : mechanism.drivers)
    driver.motion =
        Polynomial{{mechanism.estimate.at(mechanism.entities.at(driver.coordinate).first)}};
}

/// Code for what nobody has foreseen is written all the same; to compile it would take too long.
void check_code(const Variant& variant, const Model& mechanism, const TimeGrid& grid) {
  const generate::LibraryContents contents{variant.is_explicit(), variant.is_explicit() ? 4 : 1};
  try {
    const load::WantedTypes wanted =
        load::wanted_types(variant, contents, mechanism, grid, KernelTable::built_in());
    const std::string source = generate::library_source(wanted.types, contents);
    if (source.empty() != wanted.types.empty())
      throw Finding("code: none for any type", wanted.types.front().type.fingerprint);
  } catch (const load::Unavailable&) {
  }
}

const Variant& affordable(const Variant& variant, const Model& mechanism) {
  return bench::is_dense_global(variant) && mechanism.coordinates() > max_dense
             ? find_variant("global_automatic_klu")
             : variant;
}

}  // namespace

TrialOutcome attempt(std::string_view text, const std::filesystem::path& folder,
                     const Variant& variant) {
  Scene scene;
  const bool is_scene = names_scene(text);
  if (!passes<InputError>("file", folder, [&] {
        scene = is_scene ? parse_scene(text, file_name, folder)
                         : at_rest(parse_mechanism(text, file_name));
      }))
    return TrialOutcome::refused_as_file;
  passes<void>("writer", folder, [&] { check_writer(scene.mechanism); });

  Model whole;
  if (!passes<std::invalid_argument>("model", folder, [&] {
        ModellingResult modelled = model_mechanism(scene.mechanism, scene.motions);
        whole = std::move(modelled.model);
        for (const LeftOut& l : modelled.left_out) check_message(l.equation, "model");
        if (!is_scene) rest_where_measured(whole);
      }))
    return TrialOutcome::refused_as_mechanism;
  passes<void>("model", folder, [&] { validate(whole); });

  Plan plan;
  passes<void>("plan", folder, [&] {
    plan = make_plan(whole, outputs_of(scene, whole));
    validate(plan.model);
  });

  std::unique_ptr<Formulation> formulation;
  if (!passes<std::invalid_argument>("formulation", folder, [&] {
        formulation = make_formulation(affordable(variant, plan.model), plan.model,
                                       Settings{scene.tolerance});
      }))
    return TrialOutcome::refused_by_formulation;

  TrialOutcome outcome = TrialOutcome::solved;
  passes<void>("solution", folder, [&] {
    formulation->solve_only(plan.levels);
    const Level level = plan.level();
    for (int i = 0; i < std::min(scene.grid.instants, max_instants); ++i) {
      const double t = scene.grid.time(i);
      const Summary s = i == 0 ? formulation->assemble(t, level) : formulation->step(t, level);
      if (!s.ok()) {
        check_message(describe(s, plan.model), "summary");
        outcome = TrialOutcome::not_solved;
        return;
      }
      check_residual(s, formulation->tolerance());
      check_delivered(plan, *formulation, t);
    }
  });
  if (outcome == TrialOutcome::solved)
    passes<void>("code", folder, [&] {
      const TimeGrid begin{scene.grid.start, scene.grid.step, max_instants};
      check_code(variant, plan.model, begin);
    });
  return outcome;
}

}  // namespace desmo::fuzz
