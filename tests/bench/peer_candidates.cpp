// Peers are held to what our formulations are held to. A peer made of one of ours stands for the
// libraries, which not every build has.

#include <gtest/gtest.h>

#include <map>
#include <stdexcept>
#include <string>

#include "bench/experiments/paper/peer_candidate.h"
#include "cases/generators/cases.h"
#include "formulations/motion/prediction/guess.h"
#include "formulations/variants.h"

namespace desmo::paper::peer_candidates_test {
namespace {

/// Tells of a mechanism every second coordinate, as a formulation finds it.
class HalfOfOurs : public Peer {
 public:
  explicit HalfOfOurs(const Model& m)
      : formulation_(make_formulation(find_variant("group_symbolic_inlined"), m)) {
    for (int i = 0; i < m.coordinates(); i += 2) answer_.coordinates.push_back(i);
  }
  void assemble(double t) override {
    iterations_ = formulation_->assemble(t).iterations;
    take();
  }
  void step(double t) override {
    iterations_ += formulation_->step(t).iterations;
    take();
  }

 private:
  void take() {
    for (auto* values : {&answer_.q, &answer_.qd, &answer_.qdd}) values->clear();
    for (const int i : answer_.coordinates) {
      answer_.q.push_back(formulation_->q()[i]);
      answer_.qd.push_back(formulation_->qd()[i]);
      answer_.qdd.push_back(formulation_->qdd()[i]);
    }
  }
  std::unique_ptr<Formulation> formulation_;
};

class WrongInAcceleration final : public HalfOfOurs {
 public:
  using HalfOfOurs::HalfOfOurs;
  void step(double t) override {
    HalfOfOurs::step(t);
    answer_.qdd.back() += 2e-7;
  }
};

class FailsAfterAWhile final : public HalfOfOurs {
 public:
  using HalfOfOurs::HalfOfOurs;
  void step(double t) override {
    if (t > 0.3) throw std::runtime_error("lost its way");
    HalfOfOurs::step(t);
  }
};

template <class Kind>
PeerDefinition definition() {
  return {"half", "ours", [] { return std::string("1.0"); }, "by a formulation",
          [](const Scene&, const Model& m) -> std::unique_ptr<Peer> {
            return std::make_unique<Kind>(m);
          }};
}

struct PeerCells : testing::Test {
  PeerCells() { options.duration = 1; }
  Options options;
};

TEST_F(PeerCells, AreVerifiedInWhatTheyFind) {
  const PeerDefinition half = definition<HalfOfOurs>();
  PeerCandidate candidate(measured_case(find_case("truck_suspension"), 114, options), half,
                          options);
  EXPECT_EQ(candidate.name(), "truck_suspension/114/peer:half");
  candidate.verify();
  ASSERT_TRUE(candidate.is_verified()) << candidate.message();
  EXPECT_EQ(candidate.verifying_run().errors.instants, 51);
  EXPECT_GT(candidate.verifying_run().errors.position, 0);
  EXPECT_LT(candidate.verifying_run().errors.position, 1e-9);
  EXPECT_GT(candidate.verifying_run().iterations_per_step, 1);
  EXPECT_TRUE(candidate.time_afresh()) << candidate.message();
}

TEST_F(PeerCells, FailWithAWrongAnswer) {
  const PeerDefinition wrong = definition<WrongInAcceleration>();
  PeerCandidate candidate(measured_case(find_case("truck_suspension"), 114, options), wrong,
                          options);
  candidate.verify();
  EXPECT_TRUE(candidate.is_failed());
  EXPECT_NE(candidate.message().find("acceleration"), std::string::npos) << candidate.message();
}

TEST_F(PeerCells, FailWithTheLibrarysOwnWords) {
  const PeerDefinition lost = definition<FailsAfterAWhile>();
  PeerCandidate candidate(measured_case(find_case("four_bar"), 114, options), lost, options);
  candidate.verify();
  EXPECT_TRUE(candidate.is_failed());
  EXPECT_EQ(candidate.message(), "lost its way");
}

TEST_F(PeerCells, AreLeftOutWhenTheyTakeTooLong) {
  options.peer_limit = 1e-9;
  const PeerDefinition half = definition<HalfOfOurs>();
  PeerCandidate candidate(measured_case(find_case("four_bar"), 114, options), half, options);
  candidate.verify();
  EXPECT_TRUE(candidate.is_not_run());
  EXPECT_NE(candidate.message().find("the whole motion would take"), std::string::npos)
      << candidate.message();
}

TEST_F(PeerCells, StandBesideFormulationsWithTheirGuess) {
  const auto all_peers = make_peer_candidates(options);
  const auto with_peers = make_candidates_for_peers(options);
  EXPECT_EQ(all_peers.size(), peers().size() * 11);  // five sizes and the extra one of a case
  std::map<std::string, int> by_guess;
  for (const auto& candidate : with_peers)
    ++by_guess[candidate->id().substr(candidate->id().find('/'))];
  for (const PeerDefinition& peer : peers())
    EXPECT_EQ(by_guess["/guess:" + std::string(guess_name(peer.guess))], 3 * 11) << peer.name;
  EXPECT_EQ(by_guess.size(), 2u);
}

}  // namespace
}  // namespace desmo::paper::peer_candidates_test
