#include "tests/properties/mechanisms.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "cases/io/files.h"

namespace desmo::properties {

namespace {

using Vec = Mechanism::Vec;

constexpr std::array library_names{"slider_crank",
                                   "inverted_slider_crank",
                                   "whitworth",
                                   "watt_six_bar",
                                   "stephenson_six_bar",
                                   "jansen_leg",
                                   "andrews",
                                   "rssr",
                                   "stewart",
                                   "delta",
                                   "double_wishbone",
                                   "macpherson",
                                   "truck_axle"};

std::vector<Family> all_families() {
  std::vector<Family> all;
  for (const auto drawn : {plane_families(), spatial_families(), coupled_families()})
    all.insert(all.end(), drawn.begin(), drawn.end());
  for (const char* name : library_names) all.push_back({name, nullptr});
  return all;
}

Drawn of_library(const Family& family, Random& random) {
  Drawn d{.mechanism = library_scene(family.name).mechanism};
  double low = INFINITY, high = -INFINITY;
  for (const Mechanism::Point& p : d.mechanism.points) {
    low = std::min(low, *std::ranges::min_element(p.position));
    high = std::max(high, *std::ranges::max_element(p.position));
  }
  bool several = false;
  for (const Mechanism::Coordinate& c : d.mechanism.coordinates) {
    if (!c.driven) continue;
    const double unit = c.is_angle() ? 1 : 0.2 * (high - low);
    d.direction.push_back(several ? unit * random.uniform(-1, 1) : unit);
    several = true;
  }
  return d;
}

/// A rotation, a change of size and a shift, in this order.
struct Placement {
  std::array<Vec, 3> turn{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  double size = 1;
  Vec shift{};

  Vec direction(const Vec& v) const {
    Vec result{};
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) result[i] += turn[i][j] * v[j];
    return result;
  }
  Vec position(const Vec& p) const {
    Vec result = direction(p);
    for (int i = 0; i < 3; ++i) result[i] = size * (result[i] + shift[i]);
    return result;
  }
};

void turn(Placement& placement, int i, int j, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  for (int k = 0; k < 3; ++k) {
    const double x = placement.turn[i][k], y = placement.turn[j][k];
    placement.turn[i][k] = c * x - s * y;
    placement.turn[j][k] = s * x + c * y;
  }
}

Placement draw_placement(const Drawn& d, Random& random) {
  Placement p;
  const Mechanism& m = d.mechanism;
  p.size = d.exact ? std::ldexp(1, random.below(31) - 10) : random.log_uniform(1e-3, 1e6);
  if (random.chance(0.3)) p.size = 1;
  if (random.chance(0.3))
    for (int i = 0; i < m.dimension; ++i) {
      const int sign = random.sign();
      const double far = sign * random.log_uniform(1, 1e4);
      p.shift[i] = d.exact ? std::nearbyint(far) : far;
    }
  const bool turns = !d.exact && random.chance(0.5) &&
                     std::ranges::none_of(m.coordinates, [](const Mechanism::Coordinate& c) {
                       return c.type == Mechanism::CoordinateType::component;
                     });
  if (turns) turn(p, 0, 1, random.uniform(-3, 3));
  if (turns && m.dimension == 3) turn(p, 1, 2, random.uniform(-3, 3));
  return p;
}

void place(Drawn& d, const Placement& p) {
  Mechanism& m = d.mechanism;
  for (Mechanism::Point& point : m.points) point = {point.name, p.position(point.position)};
  for (Mechanism::Vector& vector : m.vectors)
    vector = {vector.name, p.direction(vector.direction), vector.along};
  for (Mechanism::Body& body : m.bodies)
    if (body.length) body.length = body.length->value * p.size;
  for (Mechanism::Coupling& coupling : m.couplings)
    for (Mechanism::Coupling::Term& term : coupling.terms)
      if (!m.coordinates[term.coordinate].is_angle()) term.factor = term.factor / p.size;
  std::size_t driver = 0;
  for (Mechanism::Coordinate& c : m.coordinates) {
    if (!c.is_angle() && c.estimate) *c.estimate *= p.size;
    if (c.driven) d.direction[driver++] *= c.is_angle() ? 1 : p.size;
  }
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = all_families();
  return all;
}

const Family& chosen_family(Random& random) {
  const std::vector<Family>& all = families();
  const auto drawn = static_cast<int>(
      std::ranges::count_if(all, [](const Family& f) { return f.draw != nullptr; }));
  const int library = static_cast<int>(all.size()) - drawn;
  return random.chance(0.7) ? all[random.below(drawn)] : all[drawn + random.below(library)];
}

Drawn draw(const Family& family, Random& random) {
  Drawn d = family.draw ? family.draw(random) : of_library(family, random);
  place(d, draw_placement(d, random));
  return d;
}

}  // namespace desmo::properties
