#include "bench/experiments/paper/case_candidate.h"

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/kit/checked_run.h"
#include "bench/kit/record/record.h"
#include "bench/kit/variant_costs.h"
#include "cases/mechanism/names.h"
#include "formulations/variants.h"

namespace desmo::paper {

using namespace bench;

namespace {

constexpr int profiled_instants = 51;

/// Returns whether a variant is run at extra sizes: counterparts of the paper's FBL-G (sparse
/// global automatic ones) and FBL-TP (generated ones, in groups or blocks).
bool runs_at_extra_sizes(const Variant& v) {
  if (v.is_generated()) return true;
  return v.partition == Partition::global && v.evaluation == Evaluation::automatic &&
         !is_dense_global(v);
}

/// Returns why a formulation is not run at this number of coordinates; empty when it is.
std::string too_costly(const Variant& v, int n, const Options& options) {
  const auto up_to = [](int limit) {
    return ": run up to " + std::to_string(limit) + " coordinates only";
  };
  if (is_dense_global(v) && n > options.dense_limit)
    return "a dense global solve costs O(n^3) a step" + up_to(options.dense_limit);
  if (n > options.slow_limit && !slow_reason(v).empty())
    return std::string(slow_reason(v)) + up_to(options.slow_limit);
  return {};
}

}  // namespace

CaseCandidate::CaseCandidate(std::shared_ptr<MeasuredCase> measured, const TimedConfiguration& c,
                             const Options& options)
    : FormulationCandidate(*measured, id_with(*c.variant, c.settings).append(suffix_of(c.check)), c,
                           c.clock),
      measured_(std::move(measured)),
      check_(c.check) {
  if (std::string reason = too_costly(variant(), coordinates(), options); !reason.empty())
    refuse(not_run(std::move(reason)));
}

Summary CaseCandidate::run(Formulation& formulation, Observer& observer) const {
  return run_under_check(formulation, grid(), request_, observer, check_);
}

void CaseCandidate::add_to(nlohmann::ordered_json& lists) const {
  const nlohmann::ordered_json key = {
      {"case", case_name()}, {"coordinates", coordinates()}, {"id", id()}};
  lists["candidates"].push_back(with_measurement(key, *this));
  if (!phases_ || !is_verified()) return;
  nlohmann::ordered_json seconds, profile = key;
  for (std::size_t p = 0; p < phase_names.size(); ++p) seconds[phase_names[p]] = (*phases_)[p];
  profile["time_per_step"] = {{"clock", "wall"}, {"phases", seconds}};
  lists["profiles"].push_back(std::move(profile));
}

void CaseCandidate::profile() {
  if (!is_verified() || !measured_->is_profiled) return;
  // A generated elimination has no phases.
  if (variant().is_generated()) return;
  // Only the paper's settings are profiled and, since KLU is not the paper's, KLU as one block.
  if (id() != variant().id && id() != reference_of_one_block) return;
  // Reading the clock costs more than what it measures in blocks of one unknown.
  if (variant().partition == Partition::block) return;
  TimeGrid first = grid();
  first.instants = std::min(grid().instants, profiled_instants);
  phases_ = measure_phases(variant(), settings(), problem().plan.model, first);
}

std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options) {
  std::vector<std::unique_ptr<CaseCandidate>> candidates;
  for (const Case& c : cases()) {
    std::map<int, std::shared_ptr<MeasuredCase>> sizes;
    const auto make = [&](int n, const TimedConfiguration& t) {
      std::shared_ptr<MeasuredCase>& measured = sizes[n];
      if (!measured) measured = measured_case(c, n, options);
      candidates.push_back(std::make_unique<CaseCandidate>(measured, t, options));
    };
    for (const int n : c.sizes)
      for (const Variant& v : variants()) make(n, {{&v, {}}});
    for (const int n : c.extra_sizes)
      for (const Variant& v : variants())
        if (runs_at_extra_sizes(v)) make(n, {{&v, {}}});
    for (const TimedConfiguration& t : beyond_the_table()) make(c.sizes.back(), t);
    for (const std::string& id : options.formulations)
      for (const int n : c.sizes)
        for (const TimedConfiguration& t : with_counterpart(id)) make(n, t);
  }
  return candidates;
}

std::vector<std::unique_ptr<CaseCandidate>> make_scene_candidates(const Options& options) {
  std::vector<TimedConfiguration> configurations;
  for (const Variant& v : variants()) configurations.push_back({{&v, {}}});
  const auto add = [&](const std::vector<TimedConfiguration>& more) {
    configurations.insert(configurations.end(), more.begin(), more.end());
  };
  add(beyond_the_table());
  for (const std::string& id : options.formulations) add(with_counterpart(id));

  std::vector<std::unique_ptr<CaseCandidate>> candidates;
  std::set<std::string> names;
  for (const std::string& file : options.scenes) {
    const auto scene = measured_scene(file, options);
    if (!names.insert(scene->case_name).second)
      throw std::invalid_argument("--scene: two files have the name " +
                                  in_quotes(scene->case_name));
    for (const TimedConfiguration& c : configurations)
      candidates.push_back(std::make_unique<CaseCandidate>(scene, c, options));
  }
  return candidates;
}

}  // namespace desmo::paper
