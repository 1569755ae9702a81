#include "bench/experiments/paper/peer_candidate.h"

#include <algorithm>
#include <array>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>
#include <vector>

#include "bench/kit/candidate_name.h"
#include "bench/kit/digests.h"
#include "bench/kit/record/record.h"
#include "cases/mechanism/formatted.h"
#include "formulations/motion/prediction/guess.h"

namespace desmo::paper {

using namespace bench;

namespace {

/// Our formulations that peers are compared with: the nearest in method, the counterpart of the
/// paper's fastest, and generated closed forms.
constexpr std::array<std::string_view, 3> formulations{
    "global_automatic_klu", "group_symbolic_inlined", "group_symbolic_explicit"};

/// Number of instants after which the time of the whole motion is estimated.
constexpr int instants_of_estimate = 50;

void solve(Peer& peer, const TimeGrid& grid, int i) {
  if (i > 0) return peer.step(grid.time(i));
  peer.expect(grid);
  peer.assemble(grid.time(0));
}

void compare(Differences& errors, const Peer::Answer& answer, const ReferenceInstant& reference) {
  ++errors.instants;
  for (std::size_t k = 0; k < answer.coordinates.size(); ++k)
    for (const Level level : all_levels)
      raise_to_difference(errors[level], values_at(answer, level)[k],
                          values_at(reference, level)[answer.coordinates[k]]);
}

template <class Make>
void for_every_size(const Options& options, Make&& make) {
  for (const Case& c : cases())
    for (const std::vector<int>* sizes : {&c.sizes, &c.extra_sizes})
      for (const int n : *sizes) make(measured_case(c, n, options));
}

}  // namespace

PeerCandidate::PeerCandidate(std::shared_ptr<const MeasuredCase> measured, const PeerDefinition& p,
                             const Options& options)
    : Candidate(measured->grid),
      measured_(std::move(measured)),
      peer_(p),
      limit_(options.peer_limit) {}

std::string PeerCandidate::name() const {
  return CandidateName{model().name, model().coordinates(), "peer:" + std::string(peer_.name)}
      .text();
}

PeerCandidate::Checked PeerCandidate::check(VerifyingRun& found) {
  found.model = model_digest(model());
  const double before_setup = cpu_now();
  const auto solver = peer_.make(measured_->scene, model());
  found.setup_seconds = cpu_now() - before_setup;

  const auto reference = shared_reference(model(), grid());
  const double start = cpu_now();
  for (int i = 0; i < grid().instants; ++i) {
    solve(*solver, grid(), i);
    const std::size_t next = found.errors.instants;
    if (next < reference.size() && reference[next].time == grid().time(i))
      compare(found.errors, solver->answer(), reference[next]);
    if (i + 1 != instants_of_estimate) continue;
    const double whole = (cpu_now() - start) / instants_of_estimate * grid().instants;
    if (whole > limit_)
      return not_run(
          formatted("the whole motion would take some %.0f s; the limit is %.0f s", whole, limit_));
  }
  found.analysis_seconds = cpu_now() - start;
  found.iterations_per_step = static_cast<double>(solver->iterations()) / grid().instants;
  std::string wrong = verification_failure(found.errors, reference.size());
  if (wrong.empty()) return {};
  return failed(std::move(wrong));
}

Analysis PeerCandidate::make_analysis(TimingWindows& windows) const {
  const std::shared_ptr<Peer> solver = peer_.make(measured_->scene, model());
  solver->assemble(grid().time(0));
  const std::vector<double> zeros(solver->answer().coordinates.size());
  // The analysis copies all answers to vectors of its own, like a delivery.
  return [this, solver, &windows, q = zeros, qd = zeros, qdd = zeros]() mutable {
    windows.begin();
    for (int i = 0; i < grid().instants; ++i) {
      solve(*solver, grid(), i);
      std::ranges::copy(solver->answer().q, q.begin());
      std::ranges::copy(solver->answer().qd, qd.begin());
      std::ranges::copy(solver->answer().qdd, qdd.begin());
      windows.count_instant();
    }
  };
}

void PeerCandidate::add_to(nlohmann::ordered_json& lists) const {
  lists["peers"].push_back(with_measurement({{"case", model().name},
                                             {"coordinates", model().coordinates()},
                                             {"peer", peer_.name},
                                             {"library", peer_.library},
                                             {"library_version", peer_.version()},
                                             {"method", peer_.method},
                                             {"guess", guess_name(peer_.guess)}},
                                            *this));
}

std::vector<std::unique_ptr<PeerCandidate>> make_peer_candidates(const Options& options) {
  std::vector<std::unique_ptr<PeerCandidate>> candidates;
  for_every_size(options, [&](const std::shared_ptr<MeasuredCase>& measured) {
    for (const PeerDefinition& peer : peers())
      candidates.push_back(std::make_unique<PeerCandidate>(measured, peer, options));
  });
  return candidates;
}

std::vector<std::unique_ptr<CaseCandidate>> make_candidates_for_peers(const Options& options) {
  std::set<Guess> guesses;
  for (const PeerDefinition& peer : peers()) guesses.insert(peer.guess);
  std::vector<std::unique_ptr<CaseCandidate>> candidates;
  for_every_size(options, [&](const std::shared_ptr<MeasuredCase>& measured) {
    for (const Guess guess : guesses)
      for (const std::string_view id : formulations)
        candidates.push_back(std::make_unique<CaseCandidate>(
            measured, TimedConfiguration{{&find_variant(id), {.guess = guess}}}, options));
  });
  return candidates;
}

}  // namespace desmo::paper
