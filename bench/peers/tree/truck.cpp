#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "bench/peers/tree/suspension.h"
#include "bench/peers/tree/tree_peer.h"
#include "formulations/base/part.h"
#include "formulations/base/state.h"
#include "formulations/motion/prediction/motions_ahead.h"
#include "formulations/motion/prediction/predictor.h"

namespace desmo::tree {

namespace {

/// Returns the two angles of an axle. all: angles of all axles, one axle after the other.
Axle::Angles angles_of(State& all, std::size_t axle) {
  const auto two = [&](std::vector<double>& v) { return std::span<double, 2>(&v[2 * axle], 2); };
  return {two(all.q), two(all.qd), two(all.qdd)};
}

class Truck final : public TreePeer {
 public:
  Truck(const Scene& scene, const Model& model, Guess guess) : motions_(addresses(scene.motions)) {
    const int axles = static_cast<int>(scene.motions.size()) / 2;
    last_.resize(2 * axles);
    one_before_.resize(2 * axles);
    expected_ = Predictor(guess, {{0, 2 * axles}});
    // So the whole mechanism meets the tolerance, as it does in our formulations.
    const double tolerance = Settings{}.tolerance / std::sqrt(axles);
    suspensions_.reserve(axles);
    will_deliver(model, {"y1"});
    for (int a = 0; a < axles; ++a) {
      const std::string prefix = "axle" + std::to_string(a + 1) + "/";
      suspensions_.emplace_back(scene.mechanism, prefix, tolerance);
      will_deliver(model, Axle::delivered(prefix));
      will_deliver(model, Stabiliser::delivered(prefix, "6", "8"));
      will_deliver(model, Stabiliser::delivered(prefix, "7", "9"));
      will_deliver(model, Damper::delivered(prefix, "10", "11"));
      will_deliver(model, Damper::delivered(prefix, "12", "13"));
    }
  }

  void expect(const TimeGrid& grid) override { motions_.expect(grid); }

  void assemble(double t) override {
    iterations_ = 0;
    before_.reset();
    last_ = {};
    last_.resize(2 * suspensions_.size());
    solve(t);
  }

  void step(double t) override {
    const StepHistory history{t - time_, h_, Level::acceleration, before_};
    std::swap(last_, one_before_);
    expected_(history, one_before_, last_, last_.q.data());
    h_ = history.h;
    before_ = Level::acceleration;
    solve(t);
  }

 private:
  void solve(double t) {
    time_ = t;
    AnswerWriter out = writer();
    out.put(Moving<Vec>{Vec::UnitY(), Vec::Zero(), Vec::Zero()});  // y1
    int iterations = 0;
    const MotionRow heights = motions_(t);
    const auto height = [&](std::size_t wheel) {
      return Moving<double>{heights.z[wheel], heights.zd[wheel], heights.zdd[wheel]};
    };
    for (std::size_t a = 0; a < suspensions_.size(); ++a) {
      Suspension& s = suspensions_[a];
      iterations =
          std::max(iterations, s.axle.solve(height(2 * a), height(2 * a + 1), angles_of(last_, a)));
      s.axle.deliver(out);
      for (const Stabiliser& stabiliser : s.stabilisers) stabiliser.solve(s.axle.pose(), out);
      for (const Damper& damper : s.dampers) damper.solve(s.axle.pose(), out);
    }
    iterations_ += iterations;
  }

  static std::vector<const Motion*> addresses(const std::vector<Motion>& motions) {
    std::vector<const Motion*> result;
    for (const Motion& motion : motions) result.push_back(&motion);
    return result;
  }

  MotionsAhead motions_;  // motions of the left and the right wheel, axle after axle
  Predictor expected_;
  std::vector<Suspension> suspensions_;
  // Angles of all axles at the last instant and the one before it. During a step, last_ is
  // predicted.
  State last_, one_before_;
  double time_ = 0, h_ = 0;      // time of the last instant, and the step that led to it [s]
  std::optional<Level> before_;  // level of one_before_; nothing: no step was taken yet
};

}  // namespace

std::unique_ptr<Peer> make_truck(const Scene& scene, const Model& model, Guess guess) {
  return std::make_unique<Truck>(scene, model, guess);
}

}  // namespace desmo::tree
