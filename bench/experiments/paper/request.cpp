#include "bench/experiments/paper/request.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <span>
#include <stdexcept>
#include <utility>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/record/record.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/base/per_level.h"
#include "formulations/model/plan.h"
#include "formulations/modelling/measures/measures.h"
#include "formulations/modelling/modelling.h"

namespace desmo::paper {

using namespace bench;

namespace {

/// Formulations with which requests are timed: the reference, and generated ones that solve all at
/// once, by groups, and by blocks.
constexpr std::array<std::string_view, 6> requested_ids{
    "global_automatic_klu",   "global_symbolic_klu",     "group_symbolic_inlined",
    "block_symbolic_inlined", "group_symbolic_explicit", "block_symbolic_explicit"};

/// Returns the outputs that move, component by component, level by level: what never moves needs
/// no solving and no delivery. `delivered` is a coordinate of the plan's model.
std::vector<Compared> components_of(const Model& whole, const Plan& plan,
                                    std::span<const Output> outputs) {
  std::vector<Compared> result;
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const Entity& from = whole.entities[outputs[i].entity];
    const Entity& to = plan.model.entities[plan.outputs[i].entity];
    for (int k = 0; !from.fixed && k < from.size; ++k)
      for (const Level level : all_levels)
        if (level <= outputs[i].level) result.push_back({to.first + k, from.first + k, level});
  }
  return result;
}

}  // namespace

PlannedRequest::PlannedRequest(std::string_view short_name, const Scene& scene,
                               const Options& options)
    : name(short_name), title(scene.name) {
  find_case(scene.mechanism.name);  // throws where there is none
  whole = make_model(scene);
  grid = chosen_grid(scene.grid, options);
  const std::vector<Output> outputs = outputs_of(scene, *whole);
  plan = make_plan(*whole, outputs);
  compared = components_of(*whole, plan, outputs);
  if (compared.empty())
    throw std::invalid_argument("request " + name + ": asks for nothing that moves");
  for (const Compared& c : compared) delivered.push_back(c.delivered);
  std::ranges::sort(delivered);
  delivered.erase(std::ranges::unique(delivered).begin(), delivered.end());
  for (Compared& c : compared)
    c.delivered =
        static_cast<int>(std::ranges::lower_bound(delivered, c.delivered) - delivered.begin());
  unknowns = moving_unknowns(plan.model);
  all_unknowns = moving_unknowns(*whole);
}

RequestCandidate::RequestCandidate(std::shared_ptr<const PlannedRequest> request,
                                   const Configuration& c)
    : FormulationCandidate(*request, c), planned_(std::move(request)) {}

std::string RequestCandidate::name() const {
  return FormulationCandidate::name() + "/request:" + planned_->name;
}

void RequestCandidate::add_to(nlohmann::ordered_json& lists) const {
  lists["requests"].push_back(with_measurement({{"case", case_name()},
                                                {"coordinates", coordinates()},
                                                {"id", id()},
                                                {"request", planned_->name},
                                                {"title", planned_->title},
                                                {"level", level_names[planned_->plan.level()]},
                                                {"unknowns", planned_->unknowns},
                                                {"all_unknowns", planned_->all_unknowns}},
                                               *this));
}

std::vector<std::unique_ptr<RequestCandidate>> make_request_candidates(const Options& options) {
  std::vector<std::unique_ptr<RequestCandidate>> candidates;
  for (const RequestScene& source : request_scenes()) {
    const Scene scene = parse_scene(source.scene, std::string(source.name), {});
    const auto request = std::make_shared<const PlannedRequest>(source.name, scene, options);
    const auto add = [&](std::string_view id) {
      const Configuration c = parse_id(id);
      if (c.settings.threads == 1)
        candidates.push_back(std::make_unique<RequestCandidate>(request, c));
    };
    std::ranges::for_each(requested_ids, add);
    if (source.name == extended_request) std::ranges::for_each(extended_ids, add);
  }
  return candidates;
}

}  // namespace desmo::paper
