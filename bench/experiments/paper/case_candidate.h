#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/phases.h"
#include "bench/kit/formulation_candidate.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/variants.h"
#include "formulations/verification/run/check_options.h"

namespace desmo::paper {

/// Returns why a formulation is not run at this number of coordinates; empty when it is.
std::string too_costly(const Variant& variant, int coordinates, const Options& options);

/// A case at one size with one formulation, perhaps in a checked run.
class CaseCandidate final : public FormulationCandidate {
 public:
  /// Refuses the candidate (Refusal::Kind::not_run), with the reason, where it would be too costly.
  CaseCandidate(const Case& definition, int coordinates, const Variant& variant,
                const Options& options, const Settings& settings = {}, Clock clock = Clock::cpu,
                CheckMode check = CheckMode::none);

  void profile() override;
  void add_to(nlohmann::ordered_json& lists) const override;

  /// Returns what profile() measured; nothing where it measured nothing.
  const std::optional<PhaseTimes>& phases() const { return phases_; }

 private:
  /// Returns the whole case, which is made at the first call: those of all candidates are too many.
  const Problem& problem() const override;
  Summary run(Formulation& formulation, Observer& observer) const override;

  const Case& definition_;
  const CheckMode check_;
  std::optional<PhaseTimes> phases_;
  mutable std::optional<Problem> problem_;
};

/// Returns every candidate of the experiment but requests and peers, in the order of the tables.
/// Dense global solves above the limit are there too, as Refusal::Kind::not_run, with the reason.
std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options);

}  // namespace desmo::paper
