#include "bench/experiments/paper/case_candidate.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "bench/experiments/paper/entry_json.h"
#include "bench/experiments/paper/extended_ids.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/record/record.h"
#include "bench/kit/variant_costs.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/modelling.h"

namespace desmo::paper {

namespace {

constexpr int profiled_coordinates = 558;  // the largest of the paper's tables
constexpr int profiled_instants = 51;

/// Tells whether it is a counterpart of FBL-G or FBL-TP, or the latter in blocks: no others are run
/// at extra sizes.
bool runs_at_extra_sizes(const Variant& v) {
  if (v.is_generated()) return true;
  return v.partition == Partition::global && v.evaluation == Evaluation::automatic &&
         !is_dense_global(v);
}

}  // namespace

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

CaseCandidate::CaseCandidate(const Case& d, int n, const Variant& v, const Options& options,
                             const Settings& s, Clock by, CheckMode mode)
    : FormulationCandidate(chosen_grid(d.with_units(1).grid, options), d.name, n,
                           id_with(v, s).append(suffix_of(mode)), {&v, s}, by, {}),
      definition_(d),
      check_(mode) {
  if (std::string reason = too_costly(v, n, options); !reason.empty())
    refuse(not_run(std::move(reason)));
}

const Problem& CaseCandidate::problem() const {
  if (!problem_) {
    problem_.emplace();
    problem_->plan.model = make_model(make_scene(definition_, coordinates()));
  }
  return *problem_;
}

void CaseCandidate::add_to(nlohmann::ordered_json& lists) const {
  const nlohmann::ordered_json key = {
      {"case", definition_.name}, {"coordinates", coordinates()}, {"id", id()}};
  lists["cells"].push_back(with_measurement(key, *this));
  if (!phases_ || !is_verified()) return;
  nlohmann::ordered_json seconds, profile = key;
  for (int p = 0; p < phase_count; ++p) seconds[phase_names[p]] = phases_->seconds[p];
  seconds["rest"] = phases_->rest;
  profile["time_per_step"] = {{"clock", clock_name(Clock::wall)}, {"phases", seconds}};
  lists["profiles"].push_back(std::move(profile));
}

void CaseCandidate::profile() {
  if (!is_verified() || coordinates() != profiled_coordinates) return;
  // A generated elimination has no phases.
  if (variant().is_generated()) return;
  // The settings are those of the paper, which does not know KLU.
  if (id() != variant().id && id() != reference_of_one_block) return;
  // Reading the clock costs more than what it measures in blocks of one unknown.
  if (variant().partition == Partition::block) return;
  TimeGrid first = grid();
  first.instants = std::min(grid().instants, profiled_instants);
  phases_ = measure_phases(variant(), settings(), problem().plan.model, first);
}

Summary CaseCandidate::run(Formulation& formulation, Observer& observer) const {
  return run_under_check(formulation, grid(), asked_, observer, check_);
}

std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options) {
  std::vector<std::unique_ptr<CaseCandidate>> candidates;
  for (const Case& c : cases()) {
    const auto make = [&](int n, const TimedConfiguration& t) {
      candidates.push_back(
          std::make_unique<CaseCandidate>(c, n, *t.variant, options, t.settings, t.clock, t.check));
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

}  // namespace desmo::paper
