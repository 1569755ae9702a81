#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "bench/peers/tree/axle.h"
#include "bench/peers/tree/damper.h"
#include "bench/peers/tree/stabiliser.h"
#include "bench/peers/tree/tree_peer.h"
#include "formulations/guess.h"
#include "formulations/lane_motion.h"

namespace desmo::tree {

namespace {

/// An axle with all that hangs on it, and where it was.
struct Suspension {
  Suspension(const Description& d, const std::string& prefix, double tolerance)
      : axle(d, prefix, tolerance),
        stabilisers{Stabiliser(d, prefix, "6", "8"), Stabiliser(d, prefix, "7", "9")},
        dampers{Damper(d, prefix, "10", "11"), Damper(d, prefix, "12", "13")} {}

  Axle axle;
  std::array<Stabiliser, 2> stabilisers;
  std::array<Damper, 2> dampers;
  Axle::Angles last, before;
};

class Truck final : public TreePeer {
 public:
  Truck(const Scene& scene, const Mechanism& mechanism, Guess guess)
      : guess_(guess), heights_(addresses(scene.motions)) {
    const int axles = static_cast<int>(scene.motions.size()) / 2;
    // As ours: the whole mechanism meets the tolerance.
    const double tolerance = Settings{}.tolerance / std::sqrt(axles);
    suspensions_.reserve(axles);
    will_deliver(mechanism, {"y1"});
    for (int a = 0; a < axles; ++a) {
      const std::string prefix = "axle" + std::to_string(a + 1) + "/";
      suspensions_.emplace_back(scene.mechanism, prefix, tolerance);
      will_deliver(mechanism, Axle::delivered(prefix));
      will_deliver(mechanism, Stabiliser::delivered(prefix, "6", "8"));
      will_deliver(mechanism, Stabiliser::delivered(prefix, "7", "9"));
      will_deliver(mechanism, Damper::delivered(prefix, "10", "11"));
      will_deliver(mechanism, Damper::delivered(prefix, "12", "13"));
    }
  }

  void assemble(double t) override {
    iterations_ = 0;
    before_.reset();
    for (Suspension& s : suspensions_) s.last = {};
    solve(t);
  }

  void step(double t) override {
    const Past past{t - time_, h_, Level::acceleration, before_};
    const Extrapolation extrapolation(best_guess(guess_, past), past);
    constexpr CoordinateRun all_angles[] = {{0, 2}};
    for (Suspension& s : suspensions_) {
      Axle::Angles next;
      extrapolation(all_angles, s.last, s.before, next.q.data());
      s.before = s.last;
      s.last = next;
    }
    h_ = past.h;
    before_ = Level::acceleration;
    solve(t);
  }

  std::string setup() const override {
    return std::to_string(suspensions_.size()) +
           " axles one after the other: yaw and pitch of each by Newton's method from the lengths "
           "of its rods; roll, arm, levers and dampers in closed form";
  }

 private:
  void solve(double t) {
    time_ = t;
    Delivery out = delivery();
    out.put(Moving<Vec>{Vec::UnitY(), Vec::Zero(), Vec::Zero()});  // y1
    int iterations = 0;
    const std::span<const MotionSample<double>> heights = heights_(t);
    for (std::size_t a = 0; a < suspensions_.size(); ++a) {
      Suspension& s = suspensions_[a];
      iterations = std::max(iterations, s.axle.solve(heights[2 * a], heights[2 * a + 1], s.last));
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

  Guess guess_;
  MotionSampler heights_;  // of the left and the right wheels, axle after axle
  std::vector<Suspension> suspensions_;
  double time_ = 0, h_ = 0;      // of the last instant, and from the one before it
  std::optional<Level> before_;  // nothing: there is none
};

}  // namespace

std::unique_ptr<Peer> make_truck(const Scene& scene, const Mechanism& mechanism, Guess guess) {
  return std::make_unique<Truck>(scene, mechanism, guess);
}

}  // namespace desmo::tree
