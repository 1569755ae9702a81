#include "bench/experiments/paper/measured_case.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <map>
#include <stdexcept>

#include "bench/kit/verification.h"
#include "cases/io/files.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/names.h"
#include "formulations/modelling/modelling.h"
#include "formulations/runtime/own_kernels.h"
#include "formulations/variants.h"

namespace desmo::paper {

using namespace bench;

namespace {

/// Time that a compiler may take for the code of one formulation.
constexpr std::chrono::seconds compile_limit{60};

constexpr int profiled_coordinates = 558;  // size of a case that is profiled: the paper's largest

std::string name_of(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  for (const std::string_view ending : {".json", ".scene"})
    if (name.ends_with(ending)) name.erase(name.size() - ending.size());
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '_');
  return name;
}

Scene read(const std::string& file) {
  return parse_scene(read_named_text(file), printable(file, 300),
                     std::filesystem::path(file).parent_path());
}

Model model_of(const Scene& scene, const std::string& file) {
  try {
    return make_model(scene);
  } catch (const std::invalid_argument& error) {
    throw InputError(printable(file, 300) + ": " + error.what());
  }
}

std::string reason_of(const GenerationOutcome& outcome) {
  if (outcome.parts_too_large == 0) return outcome.problem;
  return "parts too large to generate code for: " + std::to_string(outcome.parts_too_large);
}

/// Adds the code of a formulation to a scene that lacks it. Returns why there is none; empty: there
/// is. reasons: results of earlier calls; keys are ids without settings other than lanes and
/// segments.
std::string missing(MeasuredCase& measured, const Configuration& c,
                    std::map<std::string, std::string>& reasons) {
  const Model& model = measured.plan.model;
  if (c.variant->evaluation == Evaluation::symbolic) {
    const auto [reason, is_new] = reasons.try_emplace(
        id_with(*c.variant, {.lanes = c.settings.lanes, .segments = c.settings.segments}));
    if (is_new)
      reason->second = reason_of(load::add_generated_code(measured.kernels, *c.variant, c.settings,
                                                          model, measured.grid, compile_limit));
    if (!reason->second.empty()) return reason->second;
  }
  return missing_code(*make_formulation(*c.variant, model, c.settings, measured.kernels));
}

}  // namespace

std::shared_ptr<MeasuredCase> measured_case(const Case& definition, int coordinates,
                                            const Options& options) {
  auto measured = std::make_shared<MeasuredCase>(make_scene(definition, coordinates));
  measured->plan.model = make_model(measured->scene);
  measured->grid = chosen_grid(measured->scene.grid, options);
  measured->is_profiled = coordinates == profiled_coordinates;
  return measured;
}

std::shared_ptr<MeasuredCase> measured_scene(const std::string& file, const Options& options) {
  const auto measured = std::make_shared<MeasuredCase>(read(file));
  const std::string& name = measured->case_name = name_of(file);
  if (name.empty() || std::ranges::find(cases(), name, &Case::name) != cases().end())
    throw std::invalid_argument("--scene " + in_quotes(file) +
                                ": a case of the suite has the name " + in_quotes(name) +
                                "; give the file another");
  measured->plan.model = model_of(measured->scene, file);
  measured->grid = chosen_grid(measured->scene.grid, options);
  measured->is_relative = true;
  measured->missing = [&scene = *measured, reasons = std::map<std::string, std::string>{}](
                          const Configuration& c) mutable { return missing(scene, c, reasons); };
  return measured;
}

}  // namespace desmo::paper
