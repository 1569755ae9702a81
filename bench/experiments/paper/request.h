#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/kit/formulation_candidate.h"
#include "bench/kit/problem.h"
#include "cases/mechanism/scene.h"
#include "formulations/id.h"

namespace desmo::paper {

/// A scene's request of a case at one size, as the problem that has to be solved for it. Its
/// results are compared with those of the whole mechanism, which shows that nothing needed was left
/// out. All formulations of the request share this object and its models.
struct PlannedRequest : bench::Problem {
  /// Throws std::invalid_argument when the scene's mechanism is not a case of the suite, or no
  /// output moves.
  PlannedRequest(std::string_view short_name, const Scene& scene, const Options& options);

  std::string name;   ///< name of the request in the benchmark's name
  std::string title;  ///< name of the scene, for people
  /// Numbers of unknowns to be found at every instant: for the request, for the whole mechanism.
  int unknowns, all_unknowns;
};

/// A request with one formulation.
class RequestCandidate final : public bench::FormulationCandidate {
 public:
  RequestCandidate(std::shared_ptr<const PlannedRequest> request,
                   const Configuration& configuration);

  /// <case>/<coordinates>/<id>/request:<name>
  std::string name() const override;
  void add_to(nlohmann::ordered_json& lists) const override;

 private:
  const std::shared_ptr<const PlannedRequest> planned_;
};

/// Returns every request of the library with every formulation that requests are timed with, on one
/// thread.
std::vector<std::unique_ptr<RequestCandidate>> make_request_candidates(const Options& options);

}  // namespace desmo::paper
