#include "tests/fuzz/trial.h"

#include <algorithm>
#include <boost/core/demangle.hpp>
#include <cmath>
#include <memory>
#include <regex>
#include <typeinfo>

#include "bench/kit/variant_costs.h"
#include "cases/io/files.h"
#include "cases/mechanism/formatted.h"
#include "cases/mechanism/names.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/modelling/modelling.h"
#include "formulations/runtime/unavailable.h"
#include "formulations/runtime/wanted_types.h"
#include "tests/fuzz/grammar.h"

namespace desmo::fuzz {
namespace {

constexpr int max_instants = 5;
constexpr int max_dense = 400;  // coordinates that a dense global solve is worth
constexpr const char* file_name = "fuzz.json";

/// Returns the beginning of a message without names and numbers, which differ from input to input
/// where the cause is one.
std::string kind_of(const std::string& message) {
  static const std::regex name("'[^']*'?"), number("[0-9]+"), control("[\\x01-\\x1f]");
  std::string kind = std::regex_replace(message.substr(0, 400), name, "'…'");
  kind = std::regex_replace(std::regex_replace(kind, number, "#"), control, " ");
  return kind.substr(0, 120);
}

/// Checks that a message is fit for a terminal: one line of UTF-8 that is not endless.
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

/// Calls f. An exception that it may throw ends the input, with an outcome; all others, and all by
/// default, are findings.
template <class Allowed = Finding, class F>
bool passes(const std::string& stage, const std::filesystem::path& folder, F f) {
  try {
    f();
    return true;
  } catch (const Finding&) {
    throw;
  } catch (const std::exception& error) {
    if (!dynamic_cast<const Allowed*>(&error))
      throw Finding(
          stage + ": " + boost::core::demangle(typeid(error).name()) + ": " + kind_of(error.what()),
          error.what());
    check_message(error.what(), stage);
    if (dynamic_cast<const InputError*>(&error)) check_refusal(error.what(), stage, folder);
    return false;
  }
}

/// Tells whether documents are equal but for the rounding of directions, which are scaled to length
/// 1 whenever they are read.
bool agree(const Json& a, const Json& b) {
  constexpr double rounding = 1e-14;
  if (a.is_number() && b.is_number()) {
    const double x = a, y = b;
    return std::abs(x - y) <= rounding * std::max(1.0, std::abs(x));
  }
  const auto same = [](const auto& x, const auto& y) {
    return x.key() == y.key() && agree(x.value(), y.value());
  };
  return a.is_structured() ? a.type() == b.type() && std::ranges::equal(a.items(), b.items(), same)
                           : a == b;
}

/// Checks that a mechanism that is written, and read again, is the same.
void check_writer(const Mechanism& mechanism) {
  constexpr std::size_t largest = 200;  // points of a mechanism that is worth the time
  if (mechanism.points.size() > largest) return;
  const std::string once = write_mechanism(mechanism);
  const std::string twice = write_mechanism(parse_mechanism(once, "written.json"));
  if (!agree(Json::parse(once), Json::parse(twice)))
    throw Finding("writer: differs when read and written again", once);
}

void check_delivered(const Plan& plan, const Formulation& f, double time) {
  for (const Output& asked : plan.outputs) {
    const Entity& e = plan.model.entities.at(asked.entity);
    if (e.fixed) continue;
    const std::span<const double> found[] = {f.q(), f.qd(), f.qdd()};
    for (int level = 0; level <= static_cast<int>(asked.level); ++level)
      if (!std::ranges::all_of(found[level].subspan(e.first, e.size),
                               [](double x) { return std::isfinite(x); }))
        throw Finding(
            "solution: success with a number that is not finite, level " + std::to_string(level),
            "'" + e.name + "' at " + std::to_string(time) + " s");
  }
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
    GenerationOutcome told;
    const std::vector<generate::SampledType> types =
        load::wanted_types(variant, contents, mechanism, grid, KernelTable::built_in(), told);
    const std::string source = generate::library_source(types, contents);
    if (source.empty() != types.empty())
      throw Finding("code: none for any type", types.front().type.fingerprint);
  } catch (const load::Unavailable&) {
  }
}

}  // namespace

TrialOutcome attempt(std::string_view text, const std::filesystem::path& folder,
                     const Variant& variant) {
  Scene scene;
  const bool is_scene = text.find("\"desmo-scene\"") != text.npos;
  if (!passes<InputError>("file", folder, [&] {
        scene = is_scene ? parse_scene(text, file_name, folder)
                         : at_rest(parse_mechanism(text, file_name));
      }))
    return TrialOutcome::refused_as_file;
  passes("writer", folder, [&] { check_writer(scene.mechanism); });

  Model whole;
  if (!passes<std::invalid_argument>("model", folder, [&] {
        ModellingResult modelled = model_mechanism(scene.mechanism, scene.motions);
        whole = std::move(modelled.model);
        for (const LeftOut& l : modelled.left_out) check_message(l.equation, "model");
        if (!is_scene) rest_where_measured(whole);
      }))
    return TrialOutcome::refused_as_mechanism;
  passes("model", folder, [&] { validate(whole); });

  Plan plan;
  passes("plan", folder, [&] {
    plan = make_plan(whole, outputs_of(scene, whole));
    validate(plan.model);
  });

  const bool is_affordable =
      !bench::is_dense_global(variant) || plan.model.coordinates() <= max_dense;
  std::unique_ptr<Formulation> formulation;
  if (!passes<std::invalid_argument>("formulation", folder, [&] {
        formulation =
            make_formulation(is_affordable ? variant : find_variant("global_automatic_klu"),
                             plan.model, Settings{scene.tolerance});
      }))
    return TrialOutcome::refused_by_formulation;

  TrialOutcome outcome = TrialOutcome::solved;
  passes("solution", folder, [&] {
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
      if (!(s.residual <= formulation->tolerance() * (1 + 1e-12)))  // but for rounding
        throw Finding("solution: success with a residual beyond the tolerance",
                      formatted("%g > %g", s.residual, formulation->tolerance()));
      check_delivered(plan, *formulation, t);
    }
  });
  if (outcome == TrialOutcome::solved)
    passes("code", folder, [&] {
      const TimeGrid begin{scene.grid.start, scene.grid.step, max_instants};
      check_code(variant, plan.model, begin);
    });
  return outcome;
}

}  // namespace desmo::fuzz
