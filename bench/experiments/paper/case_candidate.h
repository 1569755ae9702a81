#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bench/experiments/paper/extended_ids.h"
#include "bench/experiments/paper/measured_case.h"
#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/phases.h"
#include "bench/kit/formulation_candidate.h"

namespace desmo::paper {

/// A case at one size, or a user's scene, with one formulation, perhaps in a checked run.
class CaseCandidate final : public bench::FormulationCandidate {
 public:
  /// Refuses the candidate (Refusal::Kind::not_run), with the reason, where it would be too costly.
  CaseCandidate(std::shared_ptr<MeasuredCase> measured, const TimedConfiguration& configuration,
                const Options& options);

  void profile() override;
  void add_to(nlohmann::ordered_json& lists) const override;

  /// Returns what profile() measured; nothing where it measured nothing.
  const std::optional<PhaseTimes>& phases() const { return phases_; }

 private:
  Summary run(Formulation& formulation, Observer& observer) const override;

  const std::shared_ptr<MeasuredCase> measured_;
  const CheckMode check_;
  std::optional<PhaseTimes> phases_;
};

/// Returns every candidate of the experiment except requests and peers, in the order of the tables.
/// Dense global solves above the limit are there too, as Refusal::Kind::not_run, with the reason.
std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options);

/// Returns every scene of the options with every formulation, with settings beyond the paper's, and
/// with those that were asked for. Throws what measured_scene throws, and std::invalid_argument
/// where two scenes have one name.
std::vector<std::unique_ptr<CaseCandidate>> make_scene_candidates(const Options& options);

}  // namespace desmo::paper
