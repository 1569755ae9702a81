#include "bench/experiments/paper/peer_candidate.h"

#include <algorithm>
#include <array>
#include <exception>
#include <set>
#include <string_view>

#include "bench/kit/digests.h"
#include "cases/mechanism/formatted.h"
#include "formulations/modelling/modelling.h"

namespace desmo::paper {

namespace {

/// The nearest in method, the paper's fastest, and the fastest of all.
constexpr std::array<std::string_view, 3> formulations{
    "global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"};

/// Instants after which the time of the whole motion is estimated.
constexpr int instants_of_estimate = 50;

void solve(Peer& peer, const TimeGrid& grid, int i) {
  if (i > 0) return peer.step(grid.time(i));
  peer.expect(grid);
  peer.assemble(grid.time(0));
}

void compare(Differences& errors, const Peer::Answer& answer, const ReferenceInstant& reference) {
  ++errors.instants;
  for (std::size_t k = 0; k < answer.coordinates.size(); ++k) {
    const int i = answer.coordinates[k];
    widen(errors.position, answer.q[k], reference.q[i]);
    widen(errors.velocity, answer.qd[k], reference.qd[i]);
    widen(errors.acceleration, answer.qdd[k], reference.qdd[i]);
  }
}

template <class Make>
void for_every_size(Make&& make) {
  for (const Case& c : cases())
    for (const std::vector<int>* sizes : {&c.sizes, &c.extra_sizes})
      for (const int n : *sizes) make(c, n);
}

}  // namespace

PeerCandidate::PeerCandidate(const Case& d, int n, const PeerDefinition& p, const Options& options)
    : Candidate(chosen_grid(d.describe(1).grid, options)),
      definition(d),
      coordinates(n),
      peer(p),
      limit_(options.peer_limit) {}

std::string PeerCandidate::name() const {
  return std::string(definition.name) + "/" + std::to_string(coordinates) +
         "/peer:" + std::string(peer.name);
}

void PeerCandidate::verify(ReferenceCache& references) {
  verify_by([&](VerifyingRun& found) -> std::string {
    scene_ = describe(definition, coordinates);
    model_ = std::make_unique<Model>(make_model(scene_));
    found.model = model_digest(*model_);
    const double before_setup = cpu_now();
    peer_ = peer.make(scene_, *model_);
    found.setup_seconds = cpu_now() - before_setup;
    setup = peer_->setup();
    compared = static_cast<int>(peer_->answer().coordinates.size());

    const auto reference = references.get(*model_, grid);
    const double start = cpu_now();
    for (int i = 0; i < grid.instants; ++i) {
      solve(*peer_, grid, i);
      const std::size_t next = found.errors.instants;
      if (next < reference.size() && reference[next].time == grid.time(i))
        compare(found.errors, peer_->answer(), reference[next]);
      if (i + 1 != instants_of_estimate) continue;
      const double whole = (cpu_now() - start) / instants_of_estimate * grid.instants;
      if (whole <= limit_) continue;
      leave_out(
          formatted("the whole motion would take some %.0f s; the limit is %.0f s", whole, limit_));
      return {};
    }
    found.analysis_seconds = cpu_now() - start;
    found.iterations_per_step = static_cast<double>(peer_->iterations()) / grid.instants;
    for (auto* delivered : {&q_, &qd_, &qdd_}) delivered->resize(compared);
    return verification_failure(found.errors, reference.size());
  });
}

void PeerCandidate::make() {
  peer_ = peer.make(scene_, *model_);
  peer_->assemble(grid.time(0));
}

Summary PeerCandidate::analyse() {
  Summary summary;
  measured_windows().begin();
  try {
    for (int i = 0; i < grid.instants; ++i) {
      solve(*peer_, grid, i);
      std::ranges::copy(peer_->answer().q, q_.begin());
      std::ranges::copy(peer_->answer().qd, qd_.begin());
      std::ranges::copy(peer_->answer().qdd, qdd_.begin());
      measured_windows().passed();
    }
    summary.instants = grid.instants;
  } catch (const std::exception& e) {
    summary.status = Status::not_converged;
    fail(e.what());
  }
  return summary;
}

std::vector<std::unique_ptr<PeerCandidate>> make_peer_candidates(const Options& options) {
  std::vector<std::unique_ptr<PeerCandidate>> candidates;
  for_every_size([&](const Case& c, int n) {
    for (const PeerDefinition& peer : peers())
      candidates.push_back(std::make_unique<PeerCandidate>(c, n, peer, options));
  });
  return candidates;
}

std::vector<std::unique_ptr<CaseCandidate>> make_candidates_for_peers(const Options& options) {
  std::set<Guess> guesses;
  for (const PeerDefinition& peer : peers()) guesses.insert(peer.guess);
  std::vector<std::unique_ptr<CaseCandidate>> candidates;
  for_every_size([&](const Case& c, int n) {
    for (const Guess guess : guesses)
      for (const std::string_view id : formulations)
        candidates.push_back(std::make_unique<CaseCandidate>(c, n, find_variant(id), options,
                                                             Settings{.guess = guess}));
  });
  return candidates;
}

}  // namespace desmo::paper
