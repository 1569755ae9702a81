// Scenes whose drawings do not close: the lengths of links are stated.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "cases/mechanism/formatted.h"
#include "tests/properties/scene_kinds.h"

namespace desmo::properties {

namespace {

Draft draw_redrawn(Random& r, const std::string& aim, void (*change)(Mechanism&, Random&)) {
  const auto plane = plane_families();
  const Family& family = r.pick(plane);
  Drawn drawn = draw(family, r);
  change(drawn.mechanism, r);
  drawn.exact = false;
  Draft d = draft_inside(r, family.name, path_of(std::move(drawn)));
  d.aim = aim;
  return d;
}

double size_of(const Mechanism& m) {
  double size = 0;
  for (const Mechanism::Point& a : m.points)
    for (const Mechanism::Point& b : m.points)
      for (int i = 0; i < 3; ++i) size = std::max(size, std::abs(a.position[i] - b.position[i]));
  return size;
}

}  // namespace

void round_numbers(Mechanism& m, int digits) {
  const auto round = [&](double x) {
    return std::strtod(formatted("%.*g", digits, x).c_str(), nullptr);
  };
  for (Mechanism::Point& p : m.points) {
    for (double& x : p.position) x = round(x);
    p.remainder = {};
  }
  for (Mechanism::Vector& v : m.vectors)
    for (double& x : v.direction) x = round(x);
  for (Mechanism::Body& b : m.bodies)
    if (b.length) b.length = round(b.length->value);
  for (Mechanism::Coordinate& c : m.coordinates)
    if (c.estimate) c.estimate = round(*c.estimate);
}

Draft draw_rough(Random& r) {
  return draw_redrawn(r, "rough drawing", [](Mechanism& m, Random& random) {
    const double off = random.log_uniform(1e-6, 0.1) * size_of(m);
    const std::vector<int>& ground = m.bodies.front().points;
    for (std::size_t i = 0; i < m.points.size(); ++i)
      if (std::ranges::find(ground, static_cast<int>(i)) == ground.end())
        for (int k = 0; k < m.dimension; ++k) m.points[i].position[k] += random.uniform(-off, off);
  });
}

Draft draw_decimal(Random& r) {
  return draw_redrawn(r, "decimal lengths",
                      [](Mechanism& m, Random& random) { round_numbers(m, 2 + random.below(4)); });
}

}  // namespace desmo::properties
