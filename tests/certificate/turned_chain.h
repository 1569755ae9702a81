#pragma once

#include <cmath>
#include <numbers>
#include <string>

#include "cases/generators/cases.h"
#include "cases/generators/dyad_chain.h"

namespace desmo {

/// Returns the scalable four-bar, turned by 1.2 rad about the crank's pivot: no link is along an
/// axis, so that boxes along the axes do not fit the errors. Branched, it has two dyads in a row
/// that hang on the first one, a dyad between the last and the last but two, and one between the
/// last and the end of the branch.
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
    using enum Mechanism::JointType;
    struct End {
      int point, body;
    };
    const auto hang = [&](const char* name, const End& from, const Mechanism::Vec& joint,
                          double length, const End& to) {
      const int c = builder.point(std::string(name) + "/C", joint);
      const int first = builder.link(std::string(name) + "/first", from.point, c, length);
      const int second = builder.link(std::string(name) + "/second", to.point, c, length);
      builder.joint(revolute, from.body, first, {from.point});
      builder.joint(revolute, first, second, {c});
      builder.joint(revolute, to.body, second, {to.point});
      return End{c, second};
    };
    const auto pivot = [&](const char* name, double x) {
      const int point = builder.point(name, turned(x, 0));
      builder.carry(MechanismBuilder::ground, {point});
      return End{point, MechanismBuilder::ground};
    };
    const auto joint_of = [](int dyad) { return End{2 * dyad + 1, 2 * dyad + 1}; };
    const double last = spacing * dyads - 3;
    const End beside = hang("beside", joint_of(1), turned(-3, 5), link_length, pivot("P", 0));
    const End end = hang("end", beside, turned(-9, 5), link_length, pivot("Q", -6));
    hang("bridge", joint_of(dyads), turned(last - 6, 10.3), 8, joint_of(dyads - 2));
    hang("span", joint_of(dyads), turned((last - 9) / 2, 5 + last / 3), 0.7 * last, end);
  }
  return {"turned_four_bar",
          builder.release(),
          {Polynomial{{chain.start, 1}}},
          time_grid(30, 0.01),
          {},
          {}};
}

}  // namespace desmo
