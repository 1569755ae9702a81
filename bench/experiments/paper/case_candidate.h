#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/phases.h"
#include "bench/kit/candidate.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// A case at one size with one formulation.
class CaseCandidate final : public FormulationCandidate {
 public:
  /// Left out, with the reason, where it would be too costly.
  CaseCandidate(const Case& definition, int coordinates, const Variant& variant,
                const Options& options, const Settings& settings = {}, Clock clock = Clock::cpu);

  using FormulationCandidate::verify;
  /// Compares with the quadruple-precision reference.
  void verify(ReferenceCache& references) override;
  void profile() override;

  const Case& definition;
  std::optional<PhaseTimes> phases;
};

/// Returns every candidate of the experiment but requests and peers, in the order of the tables.
/// Dense global solves above the limit are there too, as Readiness::not_run, with the reason.
std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options);

}  // namespace desmo::paper
