#include <array>
#include <numbers>
#include <stdexcept>
#include <string>

#include "cases/cases.h"

namespace desmo {

namespace {

constexpr double crank_length = 2, link_length = 6, pivot_spacing = 6;

using Planar = std::array<double, 2>;
using Scalar = std::array<double, 1>;

}  // namespace

Mechanism four_bar(int dyads) {
  if (dyads < 1 || dyads > 10'000'000)
    throw std::invalid_argument("four_bar: from 1 to 10000000 dyads, not " + std::to_string(dyads));
  Mechanism m;
  m.name = "four_bar";

  const GroupId crank = m.add_group("crank", {"1"});
  const double start = std::numbers::pi / 3;
  const EntityId a = m.add_fixed(EntityKind::point, "crank/A", Planar{0, 0});
  const EntityId theta = m.add(EntityKind::angle, "crank/theta", Scalar{start}, crank);
  EntityId b = m.add(EntityKind::point, "crank/B",
                     Planar{crank_length * std::cos(start), crank_length * std::sin(start)}, crank);
  m.drive(theta, ConstantRate{start, 1});
  m.constrain<PlanarAngle>(crank, "crank angle", {a, b, theta}, {crank_length});
  m.groups[crank].entities = {a, b, theta};

  for (int k = 1; k <= dyads; ++k) {
    const std::string dyad = "dyad" + std::to_string(k);
    const GroupId g = m.add_group(dyad, {std::to_string(2 * k), std::to_string(2 * k + 1)});
    const EntityId d = m.add_fixed(EntityKind::point, dyad + "/D", Planar{pivot_spacing * k, 0});
    const EntityId c = m.add(EntityKind::point, dyad + "/C", Planar{pivot_spacing * k - 3, 5}, g);
    const EntityId psi = m.add(EntityKind::angle, dyad + "/psi", Scalar{2}, g);
    m.constrain<Length<2>>(g, dyad + " coupler", {b, c}, {link_length * link_length});
    m.constrain<PlanarAngle>(g, dyad + " rocker", {d, c, psi}, {link_length});
    m.groups[g].entities = {b, c, d, psi};
    b = c;  // the next dyad hangs on this one
  }
  validate(m);
  return m;
}

}  // namespace desmo
