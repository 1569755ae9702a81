#include "bench/experiments/paper/scene_candidate.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <utility>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/entry_json.h"
#include "bench/kit/checked_run.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/io/text_file.h"
#include "cases/mechanism/names.h"
#include "formulations/modelling/modelling.h"
#include "formulations/runtime/own_kernels.h"
#include "formulations/variants.h"

namespace desmo::paper {

namespace {

/// Time that a compiler may take for the code of one formulation.
constexpr std::chrono::seconds compile_limit{60};

std::string name_of(const std::string& file) {
  std::string name = std::filesystem::path(file).filename().string();
  for (const std::string_view ending : {".json", ".scene"})
    if (name.ends_with(ending)) name.erase(name.size() - ending.size());
  std::ranges::replace_if(
      name, [](unsigned char c) { return !std::isalnum(c) && c != '-'; }, '_');
  return name;
}

Scene read(const std::string& file) {
  const std::string shown = printable(file, 300);
  std::string text;
  try {
    text = read_text(file);
  } catch (const UnreadableFile& error) {
    throw UnreadableFile(shown + ": " + error.what());
  }
  return parse_scene(text, shown, std::filesystem::path(file).parent_path());
}

Model model_of(const Scene& scene, const std::string& file) {
  try {
    return make_model(scene);
  } catch (const std::invalid_argument& error) {
    throw InputError(printable(file, 300) + ": " + error.what());
  }
}

}  // namespace

MeasuredScene::MeasuredScene(const std::string& file, const Options& options)
    : name_(name_of(file)) {
  const Scene scene = read(file);
  if (name_.empty() || std::ranges::find(cases(), name_, &Case::name) != cases().end())
    throw std::invalid_argument("--scene " + in_quotes(file) +
                                ": a case of the suite has the name " + in_quotes(name_) +
                                "; give the file another");
  problem_.plan.model = model_of(scene, file);
  problem_.grid = chosen_grid(scene.grid, options);
}

std::string MeasuredScene::add_code(const Configuration& c) {
  if (c.variant->evaluation == Evaluation::automatic) return {};
  const std::string key =
      id_with(*c.variant, {.lanes = c.settings.lanes, .segments = c.settings.segments});
  const auto [it, is_new] = problems_.try_emplace(key);
  if (!is_new) return it->second;
  const GenerationOutcome outcome = load::add_generated_code(
      problem_.kernels, *c.variant, c.settings, problem_.plan.model, problem_.grid, compile_limit);
  if (outcome.parts_too_large > 0)
    it->second = "parts too large to generate code for: " + std::to_string(outcome.parts_too_large);
  else
    it->second = outcome.problem;
  return it->second;
}

SceneCandidate::SceneCandidate(std::shared_ptr<MeasuredScene> scene, const TimedConfiguration& c,
                               const Options& options)
    : FormulationCandidate(
          scene->problem().grid, scene->name(), scene->problem().plan.model.coordinates(),
          id_with(*c.variant, c.settings).append(bench::suffix_of(c.check)), c, c.clock, {}),
      scene_(std::move(scene)),
      check_(c.check) {
  if (std::string reason = too_costly(variant(), coordinates(), options); !reason.empty())
    refuse(not_run(std::move(reason)));
}

SceneCandidate::Checked SceneCandidate::check(ReferenceCache& references, VerifyingRun& found) {
  std::string missing = unavailable_reason(settings());
  if (missing.empty()) missing = scene_->add_code(configuration());
  if (missing.empty()) missing = missing_code(*make_formulation());
  if (!missing.empty()) return not_run(std::move(missing));
  return FormulationCandidate::check(references, found);
}

std::vector<Compared> SceneCandidate::compared(std::span<const ReferenceInstant> reference) const {
  return all_compared(delivered(), asked_.level,
                      coordinate_scales(problem().plan.model, reference));
}

Summary SceneCandidate::run(Formulation& formulation, Observer& observer) const {
  return run_under_check(formulation, grid(), asked_, observer, check_);
}

void SceneCandidate::add_to(nlohmann::ordered_json& lists) const {
  lists["cells"].push_back(with_measurement(
      {{"case", scene_->name()}, {"coordinates", coordinates()}, {"id", id()}}, *this));
}

std::vector<std::unique_ptr<SceneCandidate>> make_scene_candidates(const Options& options) {
  std::vector<TimedConfiguration> configurations;
  for (const Variant& v : variants()) configurations.push_back({{&v, {}}});
  const auto add = [&](const std::vector<TimedConfiguration>& more) {
    configurations.insert(configurations.end(), more.begin(), more.end());
  };
  add(beyond_the_table());
  for (const std::string& id : options.formulations) add(with_counterpart(id));

  std::vector<std::unique_ptr<SceneCandidate>> candidates;
  std::set<std::string> names;
  for (const std::string& file : options.scenes) {
    const auto scene = std::make_shared<MeasuredScene>(file, options);
    if (!names.insert(scene->name()).second)
      throw std::invalid_argument("--scene: two files have the name " + in_quotes(scene->name()));
    for (const TimedConfiguration& c : configurations)
      candidates.push_back(std::make_unique<SceneCandidate>(scene, c, options));
  }
  return candidates;
}

}  // namespace desmo::paper
