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

using namespace bench;

/// Tells of a mechanism every second coordinate, as a formulation finds it. After each step,
/// `spoil` gets its answer.
template <auto spoil>
class HalfOfOurs final : public Peer {
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
    spoil(t, answer_);
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

void spoil_nothing(double, Peer::Answer&) {}
void make_acceleration_wrong(double, Peer::Answer& answer) { answer.qdd.back() += 2e-7; }
void fail_after_a_while(double t, Peer::Answer&) {
  if (t > 0.3) throw std::runtime_error("lost its way");
}

template <auto spoil>
const PeerDefinition half{"half", "ours", [] { return std::string("1.0"); }, "by a formulation",
                          [](const Scene&, const Model& m) -> std::unique_ptr<Peer> {
                            return std::make_unique<HalfOfOurs<spoil>>(m);
                          }};

struct PeerCandidates : testing::Test {
  PeerCandidates() { options.duration = 1; }
  std::unique_ptr<PeerCandidate> verified(const char* name, const PeerDefinition& peer) const {
    auto candidate = std::make_unique<PeerCandidate>(measured_case(find_case(name), 114, options),
                                                     peer, options);
    candidate->verify();
    return candidate;
  }
  Options options;
};

TEST_F(PeerCandidates, AreVerifiedInWhatTheyFind) {
  const auto right = verified("truck_suspension", half<spoil_nothing>);
  PeerCandidate& candidate = *right;
  EXPECT_EQ(candidate.name(), "truck_suspension/114/peer:half");
  ASSERT_TRUE(candidate.is_verified()) << candidate.message();
  EXPECT_EQ(candidate.verifying_run().errors.instants, 51);
  EXPECT_GT(candidate.verifying_run().errors.position, 0);
  EXPECT_LT(candidate.verifying_run().errors.position, 1e-9);
  EXPECT_GT(candidate.verifying_run().iterations_per_step, 1);
  EXPECT_TRUE(candidate.time_afresh()) << candidate.message();
}

TEST_F(PeerCandidates, FailWithAWrongAnswerOrTheLibrarysOwnWords) {
  const auto wrong = verified("truck_suspension", half<make_acceleration_wrong>);
  EXPECT_TRUE(wrong->is_failed());
  EXPECT_TRUE(wrong->message().starts_with("differs from the reference")) << wrong->message();
  const auto lost = verified("four_bar", half<fail_after_a_while>);
  EXPECT_TRUE(lost->is_failed());
  EXPECT_EQ(lost->message(), "lost its way");
}

TEST_F(PeerCandidates, AreLeftOutWhenTheyTakeTooLong) {
  options.peer_limit = 1e-9;
  const auto slow = verified("four_bar", half<spoil_nothing>);
  EXPECT_TRUE(slow->is_not_run());
  EXPECT_TRUE(slow->message().starts_with("the whole motion would take")) << slow->message();
}

TEST_F(PeerCandidates, StandBesideFormulationsWithTheirGuess) {
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
