#pragma once

#include <cmath>
#include <numbers>

#include "cases/generators/cases.h"
#include "cases/generators/dyad_chain.h"

namespace desmo {

/// Returns the scalable four-bar, turned by 1.2 rad about the crank's pivot: no link is along an
/// axis, so that boxes along the axes do not fit the errors. Another two dyads may hang in a row on
/// the first one, beside the chain.
inline Scene turned_chain(int dyads, bool branched = false) {
  constexpr double turn = 1.2, link_length = 6, spacing = 6;
  const auto turned = [](double x, double y) -> Mechanism::Vec {
    return {std::cos(turn) * x - std::sin(turn) * y, std::sin(turn) * x + std::cos(turn) * y, 0};
  };
  DyadChain chain{.crank = 2, .start = std::numbers::pi / 3 + turn, .dyads = {}};
  for (int k = 1; k <= dyads; ++k)
    chain.dyads.push_back(
        {turned(spacing * k, 0), link_length, link_length, turned(spacing * k - 3, 5), 2 + turn});
  MechanismBuilder builder("turned_four_bar", 2);
  builder.set_length_unit("1");
  add(builder, chain);
  if (branched) {
    int from = 3, before = 3;  // the first dyad's joint and rocker
    for (const double x : {-3, -9}) {
      const std::string name = x < -3 ? "second" : "first";
      const Mechanism::Vec at = turned(x, 5), on_ground = turned(x + 3, 0);
      const int joint = builder.point(name + "/C", at),
                pivot = builder.point(name + "/D", on_ground);
      builder.carry(MechanismBuilder::ground, {pivot});
      const int coupler = builder.link(name + "/coupler", from, joint, link_length);
      const int rocker = builder.link(name + "/rocker", pivot, joint, link_length);
      using enum Mechanism::JointType;
      builder.joint(revolute, before, coupler, {from});
      builder.joint(revolute, coupler, rocker, {joint});
      builder.joint(revolute, MechanismBuilder::ground, rocker, {pivot});
      from = joint, before = rocker;
    }
  }
  return {"turned_four_bar",
          builder.release(),
          {Polynomial{{chain.start, 1}}},
          time_grid(30, 0.01),
          {},
          {}};
}

}  // namespace desmo
