#pragma once

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/experiments/paper/options.h"
#include "bench/kit/candidate.h"
#include "cases/generators/cases.h"
#include "cases/mechanism/motion.h"
#include "cases/mechanism/scene.h"
#include "formulations/id.h"
#include "formulations/planning/plan.h"
#include "formulations/variants.h"

namespace desmo::paper {

/// A component that a request asks for: where it stands in the whole mechanism and in the part of
/// it that is solved.
struct AskedComponent {
  int whole;
  int kept;
  Level level;
};

/// A scene's request of a case at one size, and what has to be solved for it. Shared by its
/// formulations, whose mechanisms these are.
struct PlannedRequest {
  /// Throws std::invalid_argument when the scene's mechanism is not a case of the suite, or nothing
  /// that is asked moves.
  PlannedRequest(std::string_view short_name, const Scene& scene, const Options& options);

  std::string name;   ///< in the benchmark's name
  std::string title;  ///< for people
  Model whole;
  Plan plan;
  const Case& definition;
  TimeGrid grid;
  std::vector<AskedComponent> asked;  ///< without what never moves
  std::vector<int> coordinates;       ///< of the part that is solved, those asked for, ascending
  int unknowns, all_unknowns;         ///< solved for at every instant, of how many
};

/// Returns the largest absolute differences of what is asked, at the levels asked, between two
/// formulations that step through the same instants. Throws std::runtime_error, saying where, when
/// one of them cannot be solved.
Errors max_differences(Formulation& whole, Formulation& kept, std::span<const AskedComponent> asked,
                       Level level, const TimeGrid& grid);

/// A request with one formulation.
class RequestCandidate final : public Candidate {
 public:
  RequestCandidate(std::shared_ptr<const PlannedRequest> request, const Variant& variant,
                   const Settings& settings = {}, Clock clock = Clock::cpu);

  /// The variant's, with its settings, and the clock of one thread where that is the wall's.
  std::string id() const { return id_with(variant, settings) + clock_suffix(); }
  /// <case>/<coordinates>/<id>/request:<name>
  std::string name() const override;
  /// Compares with the whole mechanism, both converged as far as double precision goes, which shows
  /// that nothing needed was left out; and, as it is timed, with the quadruple-precision reference.
  void verify(ReferenceCache& references) override;
  Summary analyse() override;
  double expected_work() const override { return request_->whole.coordinates(); }
  std::vector<std::pair<std::string, double>> counters() const override;

  const PlannedRequest& request() const { return *request_; }

  const Variant& variant;
  const Settings settings;
  double difference = 0;  ///< from the whole mechanism, at any level

 private:
  void make() override;
  void discard() override { formulation_.reset(); }
  std::unique_ptr<Formulation> made_with_tolerance(double tolerance) const;
  /// Returns what is wrong; empty when the answers are those of the whole mechanism.
  std::string compare_with_whole();
  Summary run(Observer& observer);

  std::shared_ptr<const PlannedRequest> request_;
  std::unique_ptr<Formulation> formulation_;
  WindowedDelivery delivery_;
};

/// Returns every request of the library with every formulation that requests are timed with.
std::vector<std::unique_ptr<RequestCandidate>> make_request_candidates(const Options& options);

}  // namespace desmo::paper
