#pragma once

#include <memory>
#include <string>
#include <vector>

#include "bench/experiments/paper/case_candidate.h"
#include "bench/experiments/paper/options.h"
#include "bench/kit/candidate.h"
#include "bench/peers/peer.h"
#include "cases/generators/cases.h"

namespace desmo::paper {

/// A case at one size solved by a peer.
class PeerCandidate final : public Candidate {
 public:
  PeerCandidate(const Case& definition, int coordinates, const PeerDefinition& peer,
                const Options& options);

  /// <case>/<coordinates>/peer:<name>
  std::string name() const override;
  /// Compares with the quadruple-precision reference, in the coordinates that the peer finds.
  /// Leaves it out when the whole motion would take longer than the options allow.
  void verify(ReferenceCache& references) override;
  Summary analyse() override;

  const Case& definition;
  const int coordinates;
  const PeerDefinition& peer;

 private:
  void make() override;
  void discard() override { peer_.reset(); }

  const double limit_;  // CPU seconds of the whole motion
  Scene scene_;
  std::unique_ptr<Model> model_;  // the peer refers to both
  std::unique_ptr<Peer> peer_;
  std::vector<double> q_, qd_, qdd_;  // where answers are delivered
};

/// Returns every peer of this build at every size of every case.
std::vector<std::unique_ptr<PeerCandidate>> make_peer_candidates(const Options& options);

/// Returns our formulations that peers are compared with, starting from the same guesses.
std::vector<std::unique_ptr<CaseCandidate>> make_candidates_for_peers(const Options& options);

}  // namespace desmo::paper
