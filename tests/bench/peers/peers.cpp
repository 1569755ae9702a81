// Simbody and Ceres Solver agree with the quadruple reference over the motion, in all that they
// find. Built with DESMO_PEERS only. What is written by hand is tested by tree_peer.cpp.

#include "tests/peers.h"

#include <algorithm>
#include <string>
#include <vector>

#include "bench/experiments/paper/peer_candidate.h"
#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"
#include "tests/refusal.h"
#include "tests/started.h"

namespace desmo::peers_test {
namespace {

class Peers : public testing::TestWithParam<std::string> {
 protected:
  const PeerDefinition& peer = find_peer(GetParam());
};

TEST_P(Peers, AgreeWithTheQuadrupleReference) {
  paper::Options options;
  options.duration = std::min(8.0, double{DESMO_TEST_SECONDS});  // the crank turns round
  options.peer_limit = 1e9;
  for (const auto& [name, coordinates] :
       {std::pair{"four_bar", 114}, {"truck_suspension", 114}, {"truck_suspension", 336}}) {
    paper::PeerCandidate candidate(paper::measured_case(find_case(name), coordinates, options),
                                   peer, options);
    candidate.verify();
    EXPECT_TRUE(candidate.is_verified()) << candidate.name() << ": " << candidate.message();
    EXPECT_GE(candidate.verifying_run().errors.instants, 51) << candidate.name();
    const Scene scene = make_scene(find_case(name), coordinates);
    const Model model = make_model(scene);
    const auto solver = peer.make(scene, model);
    solver->assemble(0);
    EXPECT_GE(std::ssize(solver->answer().coordinates), coordinates * 2 / 3 - 1)
        << candidate.name();
    EXPECT_LT(candidate.verifying_run().iterations_per_step, 3) << candidate.name();
    EXPECT_TRUE(candidate.time_afresh()) << candidate.message();
  }
}

TEST_P(Peers, AssembleAnewWhateverWasSolvedBefore) {
  const Scene scene = truck_suspension(1);
  const Model model = make_model(scene);
  const auto solver = peer.make(scene, model);
  solver->assemble(0);
  const std::vector<double> first = solver->answer().q;
  const long iterations = solver->iterations();
  for (int i = 1; i < 20; ++i) solver->step(0.01 * i);
  EXPECT_NE(solver->answer().q, first);
  solver->assemble(0);
  EXPECT_EQ(solver->answer().q, first);
  EXPECT_EQ(solver->iterations(), iterations);
}

TEST_P(Peers, FindEveryCoordinateOnce) {
  const Scene scene = truck_suspension(2);
  const Model model = make_model(scene);
  const auto solver = peer.make(scene, model);
  std::vector<int> found = solver->answer().coordinates;
  std::ranges::sort(found);
  EXPECT_EQ(std::ranges::adjacent_find(found), found.end());
  EXPECT_GE(found.front(), 0);
  EXPECT_LT(found.back(), model.coordinates());
}

INSTANTIATE_TEST_SUITE_P(Build, Peers, testing::ValuesIn(names_of_peers(false)),
                         [](const auto& info) { return info.param; });

using PeersOfTheBench = InFolder;

TEST_F(PeersOfTheBench, AreInItsRecordAndInTheReport) {
  const std::string record = file("record.json");
  ASSERT_EQ(shell(DESMO_BENCH " --duration=0.1 --benchmark_repetitions=2 --record=" + record +
                  " '--benchmark_filter=truck_suspension/114/.*(peer|guess):'"),
            0);
  ASSERT_EQ(shell(DESMO_REPORT " tables " + record + " --out " + folder_.string()), 0);
  const std::string table = text_of(folder_ / "peers_truck_suspension.csv");
  for (const PeerDefinition& p : peers()) EXPECT_CONTAINS(table, "," + std::string(p.name) + ",");
  EXPECT_CONTAINS(table, ",group_symbolic_explicit/guess:quadratic,");
}

TEST(SimbodyPeer, KnowsTheCasesOfTheSuiteOnly) {
  Scene scene = four_bar(1);
  const Model model = make_model(scene);
  scene.mechanism.name = "five_bar";
  EXPECT_EQ(refusal([&] { find_peer("simbody").make(scene, model); }),
            "simbody: no model of 'five_bar'");
}

}  // namespace
}  // namespace desmo::peers_test
