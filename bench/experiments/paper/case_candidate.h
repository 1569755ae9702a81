#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/experiments/paper/phases.h"
#include "bench/kit/candidate.h"
#include "bench/kit/delivery.h"
#include "bench/kit/verification.h"
#include "cases/generators/cases.h"
#include "formulations/id.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// One case at one size with one formulation.
class CaseCandidate final : public Candidate {
 public:
  CaseCandidate(const Case& definition, int coordinates, const Variant& variant,
                const Options& options, const Settings& settings = {}, Clock clock = Clock::cpu);

  /// The variant's, with its settings, and the clock of one thread where that is the wall's.
  std::string id() const { return id_with(variant, settings) + clock_suffix(); }
  /// <case>/<coordinates>/<id>
  std::string name() const override;
  /// Against the quadruple-precision reference.
  void verify(ReferenceCache& references) override;
  void profile() override;
  Summary analyse() override;
  double expected_work() const override { return coordinates; }
  std::vector<std::pair<std::string, double>> counters() const override;

  const Case& definition;
  const int coordinates;
  const Variant& variant;
  const Settings settings;

  int groups = 0, degrees_of_freedom = 0;
  std::optional<PhaseTimes> phases;

 private:
  void make() override;
  void discard() override { formulation_.reset(); }

  std::unique_ptr<Model> model_;  // the formulation refers to it
  std::unique_ptr<Formulation> formulation_;
  WindowedDelivery<Delivery> delivery_;
};

/// Every cell of the suite, in the order of the tables. Dense global solves beyond the limit are
/// there too, as State::not_run, with the reason.
std::vector<std::unique_ptr<CaseCandidate>> make_case_candidates(const Options& options);

}  // namespace desmo::paper
