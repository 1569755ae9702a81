// Peers written by hand: the same answers as ours, everywhere and in everything, and no answer
// where there is none.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

#include "bench/experiments/paper/peer_candidate.h"
#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "tests/peers.h"
#include "tests/refusal.h"

namespace desmo::tree_peer_test {
namespace {

/// Tests of all of them in one case, which share its references: these take longest.
class TreePeersOfCase : public testing::TestWithParam<std::string_view> {};

TEST_P(TreePeersOfCase, AgreeWithTheQuadrupleReferenceAtEverySize) {
  const Case& c = find_case(GetParam());
  paper::Options options;
  options.peer_limit = 1e9;
  for (const int n : c.sizes) {
    if (DESMO_SANITIZED && n > c.sizes[1]) break;
    // A size more is not a whole motion more.
    options.duration = n == c.sizes.front() ? DESMO_TEST_SECONDS : 0.5;
    for (const std::string& name : names_of_peers(true)) {
      paper::PeerCandidate candidate(paper::measured_case(c, n, options), find_peer(name), options);
      candidate.verify();
      EXPECT_TRUE(candidate.is_verified()) << candidate.name() << ": " << candidate.message();
      const Scene scene = make_scene(c, n);
      const Model model = make_model(scene);
      EXPECT_EQ(std::ssize(find_peer(name).make(scene, model)->answer().coordinates), n) << name;
      EXPECT_EQ(candidate.verifying_run().errors.instants, 51) << candidate.name();
      for (const double error :
           {candidate.verifying_run().errors.position, candidate.verifying_run().errors.velocity,
            candidate.verifying_run().errors.acceleration})
        EXPECT_LT(error, 1e-9) << candidate.name();
      EXPECT_TRUE(candidate.time_afresh()) << candidate.message();
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, TreePeersOfCase, testing::Values("four_bar", "truck_suspension"),
                         [](const auto& info) { return std::string(info.param); });

class TreePeers : public testing::TestWithParam<std::string> {
 protected:
  const PeerDefinition& peer = find_peer(GetParam());
};

TEST_P(TreePeers, AssembleAnewWhateverWasSolvedBefore) {
  const Scene scene = truck_suspension(2);
  const Model model = make_model(scene);
  const auto solver = peer.make(scene, model);
  solver->assemble(0);
  const auto first = solver->answer();
  const long iterations = solver->iterations();
  for (int i = 1; i < 20; ++i) solver->step(0.01 * i);
  EXPECT_NE(solver->answer().q, first.q);
  EXPECT_GT(solver->iterations(), iterations);
  solver->assemble(0);
  EXPECT_EQ(solver->answer().q, first.q);
  EXPECT_EQ(solver->answer().qdd, first.qdd);
  EXPECT_EQ(solver->iterations(), iterations);
}

/// The peer is not held back: it takes no more iterations than ours from the same guess to the same
/// tolerance.
TEST_P(TreePeers, NeedNoMoreIterationsThanOurs) {
  const Scene scene = truck_suspension(1);
  const Model model = make_model(scene);
  const auto solver = peer.make(scene, model);
  const auto ours =
      make_formulation(find_variant("global_automatic_klu"), model, {.guess = peer.guess});
  solver->assemble(0);
  long iterations = ours->assemble(0).iterations;
  for (int i = 1; i < 300; ++i) {
    solver->step(0.01 * i);
    iterations += ours->step(0.01 * i).iterations;
  }
  EXPECT_LE(solver->iterations(), iterations);
}

/// Heights of the wheels of axle 1 that rise from the nominal ones at the given rates, m/s.
Scene rising(double left, double right) {
  Scene scene = truck_suspension(2);
  scene.motions[0] = Polynomial{{0.5, left}};
  scene.motions[1] = Polynomial{{0.5, right}};
  return scene;
}

std::string message_of(const PeerDefinition& peer, const Scene& scene) {
  const Model model = make_model(scene);
  const auto solver = peer.make(scene, model);
  return refusal<std::runtime_error>([&] {
    solver->assemble(0);
    for (int i = 1; i < 300; ++i) {
      solver->step(0.01 * i);
      for (const double q : solver->answer().q) EXPECT_TRUE(std::isfinite(q));
    }
  });
}

TEST_P(TreePeers, SayWhatCannotBeClosedAndWhere) {
  for (const auto& [left, right] : {std::pair{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {0.0, 1.0}}) {
    const std::string said = message_of(peer, rising(left, right));
    EXPECT_TRUE(said.starts_with("axle1/")) << left << " " << right << ": " << said;
  }
  Scene bars = four_bar(3);
  bars.mechanism.bodies[1].length = 7;  // the crank takes B out of reach
  EXPECT_EQ(message_of(peer, bars), "dyad1/coupler: it does not reach the rocker");
}

TEST_P(TreePeers, KnowTheCasesOfTheSuiteOnly) {
  Scene scene = four_bar(1);
  const Model model = make_model(scene);
  scene.mechanism.name = "five_bar";
  EXPECT_THROW(peer.make(scene, model), std::invalid_argument);
}

INSTANTIATE_TEST_SUITE_P(Build, TreePeers, testing::ValuesIn(names_of_peers(true)),
                         [](const auto& info) { return info.param; });

}  // namespace
}  // namespace desmo::tree_peer_test
