#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/measured_case.h"
#include "bench/experiments/paper/options.h"
#include "bench/kit/candidate.h"
#include "bench/peers/peer.h"

namespace desmo::paper {

/// A case at one size solved by a peer.
class PeerCandidate final : public bench::Candidate {
 public:
  PeerCandidate(std::shared_ptr<const MeasuredCase> measured, const PeerDefinition& peer,
                const Options& options);

  /// <case>/<coordinates>/peer:<name>
  std::string name() const override;
  void add_to(nlohmann::ordered_json& lists) const override;

 private:
  /// Compares the coordinates that the peer finds. Refuses the peer (not_run) when the whole motion
  /// would take longer than the options allow.
  Checked check(bench::VerifyingRun& found) override;
  bench::Analysis make_analysis(bench::TimingWindows& windows) const override;

  const Model& model() const { return measured_->plan.model; }

  const std::shared_ptr<const MeasuredCase> measured_;  // which the peer refers to
  const PeerDefinition& peer_;
  const double limit_;  // largest CPU time of the whole motion [s] (≤), as estimated
};

/// Returns every peer of this build at every size of every case.
std::vector<std::unique_ptr<PeerCandidate>> make_peer_candidates(const Options& options);

/// Returns our formulations that peers are compared with, with each guess that a peer starts from,
/// at every size of every case.
std::vector<std::unique_ptr<CaseCandidate>> make_candidates_for_peers(const Options& options);

}  // namespace desmo::paper
