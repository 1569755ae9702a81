#include "cases/generators/dyad_chain.h"

#include <algorithm>
#include <cmath>

namespace desmo {

Mechanism::Vec crank_pin(const DyadChain& chain) {
  return {chain.crank * std::cos(chain.start), chain.crank * std::sin(chain.start), 0};
}

void add(MechanismBuilder& builder, const DyadChain& chain) {
  using enum Mechanism::JointType;
  const std::string crank = chain.prefix + "crank";
  const int a = builder.point(crank + "/A", {0, 0, 0});
  int b = builder.point(crank + "/B", crank_pin(chain));
  builder.carry(MechanismBuilder::ground, {a});
  int before = builder.link(crank, a, b, chain.crank);
  builder.joint(revolute, MechanismBuilder::ground, before, {a});
  Mechanism::Coordinate& theta = builder.angle(crank + "/theta", {-1, a, b});
  theta.estimate = chain.start;
  theta.driven = true;

  for (std::size_t k = 0; k < chain.dyads.size(); ++k) {
    const DyadChain::Dyad& dyad = chain.dyads[k];
    const std::string name = chain.prefix + "dyad" + std::to_string(k + 1) + "/";
    const int pivot = builder.point(name + "D", dyad.pivot);
    const int c = builder.point(name + "C", dyad.joint);
    builder.carry(MechanismBuilder::ground, {pivot});
    const int coupler = builder.link(name + "coupler", b, c, dyad.coupler);
    const int rocker = builder.link(name + "rocker", pivot, c, dyad.rocker);
    builder.joint(revolute, before, coupler, {b});
    builder.joint(revolute, coupler, rocker, {c});
    builder.joint(revolute, MechanismBuilder::ground, rocker, {pivot});
    builder.angle(name + "psi", {-1, pivot, c}).estimate = dyad.angle;
    b = c;  // the next dyad's coupler starts here
    before = rocker;
  }
}

DyadChain::Dyad closed_dyad(const Mechanism::Vec& from, const Mechanism::Vec& pivot, double coupler,
                            double rocker, int side) {
  const double ax = pivot[0] - from[0], ay = pivot[1] - from[1], length = std::hypot(ax, ay);
  // Intersects two circles. The joint is at `from` + x a + h n, where the vector a leads from
  // `from` to `pivot`, and n is a turned to the left by 90°.
  const double p = coupler / length, r = rocker / length;
  const double x = (1 + (p - r) * (p + r)) / 2;
  const double h = side * std::sqrt(std::max(0.0, (p - x) * (p + x)));
  const Mechanism::Vec joint{from[0] + x * ax - h * ay, from[1] + x * ay + h * ax, 0};
  return {pivot, coupler, rocker, joint, std::atan2(joint[1] - pivot[1], joint[0] - pivot[0])};
}

}  // namespace desmo
