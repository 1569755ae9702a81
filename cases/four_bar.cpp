#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "cases/cases.h"
#include "cases/describe.h"

namespace desmo {

Scene four_bar(int dyads) {
  if (dyads < 1 || dyads > 10'000'000)
    throw std::invalid_argument("four_bar: from 1 to 10000000 dyads, not " + std::to_string(dyads));
  using enum Description::JointType;
  constexpr double crank_length = 2, link_length = 6, pivot_spacing = 6;
  const double start = std::numbers::pi / 3;

  Describer d("four_bar", 2);
  d.set_length_unit("1");
  const int a = d.point("crank/A", {0, 0, 0});
  int b = d.point("crank/B", {crank_length * std::cos(start), crank_length * std::sin(start), 0});
  d.carry(Describer::ground, {a});
  int before = d.link("crank", a, b, crank_length);
  d.joint(revolute, Describer::ground, before, {a});
  Description::Coordinate& theta = d.coordinate("crank/theta", Description::CoordinateType::angle);
  theta.of = {-1, a, b};
  theta.estimate = start;
  theta.driven = true;

  for (int k = 1; k <= dyads; ++k) {
    const std::string dyad = "dyad" + std::to_string(k) + "/";
    const int pivot = d.point(dyad + "D", {pivot_spacing * k, 0, 0});
    const int c = d.point(dyad + "C", {pivot_spacing * k - 3, 5, 0});
    d.carry(Describer::ground, {pivot});
    const int coupler = d.link(dyad + "coupler", b, c, link_length);
    const int rocker = d.link(dyad + "rocker", pivot, c, link_length);
    d.joint(revolute, before, coupler, {b});
    d.joint(revolute, coupler, rocker, {c});
    d.joint(revolute, Describer::ground, rocker, {pivot});
    Description::Coordinate& psi = d.coordinate(dyad + "psi", Description::CoordinateType::angle);
    psi.of = {-1, pivot, c};
    psi.estimate = 2;
    b = c;  // the next dyad hangs on this one
    before = rocker;
  }
  return {"four_bar", d.take(), {Polynomial{{start, 1}}}, time_grid(30, 0.01), {}, {}, 1e-10};
}

}  // namespace desmo
