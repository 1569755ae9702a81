#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/kit/formulation_candidate.h"
#include "cases/generators/cases.h"
#include "cases/mechanism/motion.h"
#include "cases/mechanism/scene.h"
#include "formulations/id.h"
#include "formulations/model/plan.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// A component of an output: its coordinate in the whole mechanism, and in the part of it that is
/// solved.
struct OutputComponent {
  int whole;
  int kept;
  Level level;
};

/// A scene's request of a case at one size, as the problem that has to be solved for it. Shared by
/// its formulations, whose mechanisms these are.
struct PlannedRequest : Problem {
  /// Throws std::invalid_argument when the scene's mechanism is not a case of the suite, or no
  /// output moves.
  PlannedRequest(std::string_view short_name, const Scene& scene, const Options& options);

  std::string name;   ///< in the benchmark's name
  std::string title;  ///< for people
  Model whole;
  const Case& definition;
  std::vector<OutputComponent> components;  ///< without what never moves
  std::vector<int> coordinates;  ///< of the part that is solved, those of outputs, ascending
  int unknowns, all_unknowns;    ///< solved for at every instant, of how many
};

/// A request with one formulation.
class RequestCandidate final : public FormulationCandidate {
 public:
  RequestCandidate(std::shared_ptr<const PlannedRequest> request, const Variant& variant,
                   const Settings& settings = {});

  /// <case>/<coordinates>/<id>/request:<name>
  std::string name() const override;
  void add_to(nlohmann::ordered_json& lists) const override;

  const PlannedRequest& request() const { return *request_; }

 private:
  const Problem& problem() const override { return *request_; }
  std::vector<Compared> compared(std::span<const ReferenceInstant> reference) const override;
  /// The whole mechanism: a comparison with its motion shows that nothing needed was left out.
  const Model& whole() const override { return request_->whole; }

  std::shared_ptr<const PlannedRequest> request_;
};

/// Returns every request of the library with every formulation that requests are timed with, on one
/// thread.
std::vector<std::unique_ptr<RequestCandidate>> make_request_candidates(const Options& options);

}  // namespace desmo::paper
