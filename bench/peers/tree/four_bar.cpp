// A peer of four_bar in closed form: the joint C of each dyad is an intersection of two circles.

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/peers/tree/nominal.h"
#include "bench/peers/tree/tree_peer.h"

namespace desmo::tree {

namespace {

using Vec2 = Eigen::Vector2d;

/// Returns a vector turned by 90° to the left.
Vec2 left_of(const Vec2& a) { return {-a.y(), a.x()}; }

Vec2 nominal_in_plane(const Mechanism& mechanism, const std::string& point) {
  return nominal(mechanism, point).head<2>();
}

/// A coupler of length c from B, which is known, to C, and a rocker of length r from D to C:
///   C = D + r ρ,  ρ = (cos ψ, sin ψ),  ‖C − B‖ = c.
class Dyad {
 public:
  /// prefix: first part of the dyad's names. before: name of the point B.
  Dyad(const Mechanism& mechanism, const std::string& prefix, const std::string& before)
      : name_(prefix),
        pivot_(nominal_in_plane(mechanism, prefix + "D")),
        coupler_(length(mechanism, prefix + "coupler")),
        rocker_(length(mechanism, prefix + "rocker")) {
    const Vec2 way = pivot_ - nominal_in_plane(mechanism, before);
    side_ =
        std::copysign(1.0, left_of(way).dot(nominal_in_plane(mechanism, prefix + "C") - pivot_));
  }

  /// Returns C, given B, and writes C and ψ. Throws std::runtime_error, naming the dyad, when the
  /// circles do not meet in two points.
  Moving<Vec2> solve(const Moving<Vec2>& b, AnswerWriter& out) const {
    const Vec2 way = pivot_ - b.q;  // E = D − B; E·ρ = k
    const double square = way.squaredNorm();
    const double k = (coupler_ * coupler_ - rocker_ * rocker_ - square) / (2 * rocker_);
    const double rest = square - k * k;
    if (!(rest > 0)) throw std::runtime_error(name_ + "coupler: it does not reach the rocker");
    const double w = side_ * std::sqrt(rest);
    const Vec2 rho = (1 / square) * (k * way + w * left_of(way)), across = left_of(rho);

    // (C−B)·(Ċ−Ḃ) = 0 and (C−B)·(C̈−B̈) + ‖Ċ−Ḃ‖² = 0, where (C−B)·ρ⊥ = −w.
    const Vec2 coupler = way + rocker_ * rho;
    const double per_angle = -1 / (rocker_ * w);
    const double rate = per_angle * coupler.dot(b.qd);
    const Vec2 velocity = rocker_ * rate * across, inward = -rocker_ * rate * rate * rho;
    const double second_rate =
        per_angle * (coupler.dot(b.qdd - inward) - (velocity - b.qd).squaredNorm());

    const Moving<Vec2> c{pivot_ + rocker_ * rho, velocity, inward + rocker_ * second_rate * across};
    out.put(c);
    out.put(Moving<double>{std::atan2(rho.y(), rho.x()), rate, second_rate});
    return c;
  }

 private:
  std::string name_;
  Vec2 pivot_;               // D
  double coupler_, rocker_;  // lengths c and r
  double side_;              // 1: C is left of the line from B to D; -1: right of it
};

class FourBar final : public TreePeer {
 public:
  FourBar(const Scene& scene, const Model& model)
      : motion_(scene.motions.at(0)),
        pivot_(nominal_in_plane(scene.mechanism, "crank/A")),
        crank_(length(scene.mechanism, "crank")) {
    const Mechanism& mechanism = scene.mechanism;
    will_deliver(model, {"crank/theta", "crank/B"});
    // Ground and crank belong to no dyad.
    const int dyads = static_cast<int>(mechanism.bodies.size() - 2) / 2;
    std::string before = "crank/B";
    for (int k = 1; k <= dyads; ++k) {
      const std::string prefix = "dyad" + std::to_string(k) + "/";
      dyads_.emplace_back(mechanism, prefix, before);
      before = prefix + "C";
      will_deliver(model, {before, prefix + "psi"});
    }
  }

  void assemble(double t) override {
    const auto [theta, rate, second_rate] = sample(motion_, t);
    const Vec2 arm = crank_ * Vec2(std::cos(theta), std::sin(theta)), across = left_of(arm);
    Moving<Vec2> b{pivot_ + arm, rate * across, second_rate * across - rate * rate * arm};
    AnswerWriter out = writer();
    out.put(Moving<double>{theta, rate, second_rate});
    out.put(b);
    for (const Dyad& dyad : dyads_) b = dyad.solve(b, out);
  }
  void step(double t) override { assemble(t); }

 private:
  const Motion& motion_;
  Vec2 pivot_;
  double crank_;  // length of the crank
  std::vector<Dyad> dyads_;
};

}  // namespace

std::unique_ptr<Peer> make_four_bar(const Scene& scene, const Model& model) {
  return std::make_unique<FourBar>(scene, model);
}

}  // namespace desmo::tree
