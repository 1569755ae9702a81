#include "bench/experiments/extremes/chain_solution.h"

#include <algorithm>
#include <boost/math/constants/constants.hpp>
#include <cmath>
#include <string>

#include "formulations/model/scales.h"

namespace desmo::extremes {

namespace {

const Quadruple turn = 2 * boost::math::constants::pi<Quadruple>();

/// Returns the angle that differs from `angle` by whole turns and is nearest to `before`.
Quadruple near(const Quadruple& angle, double before) {
  return angle + turn * round((Quadruple(before) - angle) / turn);
}

}  // namespace

ChainSolution::ChainSolution(const DyadChain& chain, const Model& m)
    : chain_(chain), m_(m), size_(nominal_size(m)), now_{0, {}, {}, {}} {
  const auto coordinate = [&](const std::string& name) {
    return m.coordinate(chain.prefix + name);
  };
  crank_angle_ = coordinate("crank/theta");
  crank_joint_ = coordinate("crank/B.x");
  for (std::size_t k = 1; k <= chain.dyads.size(); ++k) {
    const std::string dyad = "dyad" + std::to_string(k);
    places_.push_back({coordinate(dyad + "/C.x"), coordinate(dyad + "/psi"), 0, 0});
  }
  for (std::vector<Quadruple>* values : {&now_.q, &now_.qd, &now_.qdd})
    values->resize(m.coordinates());
  declare(m.estimate);
}

void ChainSolution::declare(std::span<const double> q) {
  int from = crank_joint_;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    Place& place = places_[k];
    const auto [x, y, z] = chain_.dyads[k].pivot;
    const double to_joint_x = q[place.joint] - q[from];
    const double to_joint_y = q[place.joint + 1] - q[from + 1];
    const double left = (x - q[from]) * to_joint_y - (y - q[from + 1]) * to_joint_x;
    place.side = left < 0 ? -1 : 1;
    place.last_angle = q[place.angle];
    from = place.joint;
  }
}

bool ChainSolution::solve(double t) {
  const Motion& motion = m_.drivers.front().motion;
  // A motion that is not finite in double precision counts as none, even if it is finite in
  // quadruple precision.
  const MotionSample<double> driven = sample(motion, t);
  if (!std::isfinite(driven.position) || !std::isfinite(driven.velocity) ||
      !std::isfinite(driven.acceleration))
    return false;
  const auto [theta, rate, second] = sample(motion, Quadruple(t));
  const Quadruple c = chain_.crank * cos(theta), s = chain_.crank * sin(theta);
  Joint joint{
      c, s, -rate * s, rate * c, -second * s - rate * rate * c, second * c - rate * rate * s};
  now_.time = t;
  put(crank_angle_, theta, rate, second);
  put(crank_joint_, joint);
  along_ = any_way_ = chain_.crank;
  condition_ = any_way_ / size_;
  for (std::size_t k = 0; k < places_.size(); ++k) {
    const Joint from = joint;
    if (!close(k, from, joint)) return false;
  }
  return true;
}

bool ChainSolution::close(std::size_t k, const Joint& b, Joint& c) {
  const DyadChain::Dyad& dyad = chain_.dyads[k];
  Place& place = places_[k];
  const Quadruple p = dyad.coupler, r = dyad.rocker;
  const Quadruple ax = dyad.pivot[0] - b.x, ay = dyad.pivot[1] - b.y, a2 = ax * ax + ay * ay;
  // C is where two circles meet: C − B = x a + h a⊥, where a leads from B to the pivot D.
  const Quadruple x = (1 + (p - r) * (p + r) / a2) / 2, h2 = p * p / a2 - x * x;
  if (!(h2 > 0)) return false;
  const Quadruple h = place.side * sqrt(h2);
  const Quadruple ex = x * ax - h * ay, ey = x * ay + h * ax;  // C − B
  const Quadruple fx = ex - ax, fy = ey - ay;                  // C − D
  // C moves across the rocker, Ċ = ω f⊥, and along the coupler as B does.
  const Quadruple across = ey * fx - ex * fy;  // e·f⊥
  const Quadruple omega = (ex * b.vx + ey * b.vy) / across;
  const Quadruple vx = -omega * fy, vy = omega * fx, rx = vx - b.vx, ry = vy - b.vy;
  const Quadruple omega2 = omega * omega;
  const Quadruple alpha =
      (ex * (b.ax + omega2 * fx) + ey * (b.ay + omega2 * fy) - (rx * rx + ry * ry)) / across;
  const Quadruple psi = near(atan2(fy, fx), place.last_angle);
  place.last_angle = static_cast<double>(psi);

  // moved: error, divided by the unit roundoff, of the equation that places C on its circle. The
  // error of B contributes its component along the coupler; along_ is in the direction of B's
  // velocity. The rounding of both lengths contributes, too.
  const Quadruple speed = sqrt(b.vx * b.vx + b.vy * b.vy);
  const double share =
      speed > 0 ? static_cast<double>(abs(ex * b.vx + ey * b.vy) / speed) : dyad.coupler;
  const double moved =
      share * along_ + dyad.coupler * (any_way_ + dyad.coupler) + dyad.rocker * dyad.rocker;
  along_ = dyad.rocker * moved / std::abs(static_cast<double>(across));

  c = {dyad.pivot[0] + fx,        dyad.pivot[1] + fy,      vx, vy,
       -alpha * fy - omega2 * fx, alpha * fx - omega2 * fy};
  any_way_ = static_cast<double>(sqrt(c.x * c.x + c.y * c.y));
  condition_ = std::max(condition_, (along_ + any_way_) / size_);
  put(place.joint, c);
  put(place.angle, psi, omega, alpha);
  return true;
}

void ChainSolution::put(int i, const Joint& joint) {
  put(i, joint.x, joint.vx, joint.ax);
  put(i + 1, joint.y, joint.vy, joint.ay);
}

void ChainSolution::put(int i, const Quadruple& q, const Quadruple& qd, const Quadruple& qdd) {
  now_.q[i] = q;
  now_.qd[i] = qd;
  now_.qdd[i] = qdd;
}

}  // namespace desmo::extremes
