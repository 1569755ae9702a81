#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "bench/experiments/promise/drawn_families.h"
#include "cases/generators/dyad_chain.h"
#include "cases/mechanism/builder.h"

namespace desmo::promise {

namespace {

using Vec = Mechanism::Vec;
using enum Mechanism::JointType;
constexpr auto along = Mechanism::CoordinateType::along;

Vec polar(const Vec& from, double length, double angle) {
  return {from[0] + length * std::cos(angle), from[1] + length * std::sin(angle), 0};
}
double length_between(const Vec& a, const Vec& b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }
Vec middle(const Vec& a, const Vec& b) { return {(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, 0}; }

/// Returns where circles about two points meet, left of the line between them for side 1.
Vec meeting(const Vec& a, double from_a, const Vec& b, double from_b, int side) {
  return closed_dyad(a, b, from_a, from_b, side).joint;
}

/// A multiple of 1/8, which adds up exactly.
double eighths(Random& random, int from, int to) {
  return (from + random.below(to - from + 1)) / 8.0;
}

/// A builder that pins all bodies with the same point to each other.
class Plane {
 public:
  explicit Plane(std::string name) : b_(std::move(name), 2) { b_.set_length_unit("1"); }

  void point(const std::string& name, const Vec& at) {
    points_[name] = b_.point(name, at);
    at_[name] = at;
  }
  void ground(const std::vector<std::string>& names) {
    for (const std::string& n : names) carry(MechanismBuilder::ground, n);
  }
  int link(const std::string& a, const std::string& b) {
    return link(a, b, length_between(at_[a], at_[b]));
  }
  int link(const std::string& a, const std::string& b, double length) {
    const int body = b_.link(a + b, points_[a], points_[b], length);
    pin(body, a);
    pin(body, b);
    return body;
  }
  int body(const std::string& name, const std::vector<std::string>& names) {
    const int body = b_.body(name, {});
    for (const std::string& n : names) carry(body, n);
    return body;
  }
  void carry(int body, const std::string& name) {
    b_.carry(body, {points_[name]});
    pin(body, name);
  }
  /// The point slides on the line through `on` of the ground.
  void slide(const std::string& point, int body, const std::string& on, int vector) {
    b_.joint(revolute_on_slider, MechanismBuilder::ground, body, {points_[on], points_[point]},
             {vector});
  }
  int ground_vector(const std::string& name, const Vec& direction) {
    const int v = b_.vector(name, direction);
    b_.carry(MechanismBuilder::ground, {}, {v});
    return v;
  }
  Mechanism::Coordinate& angle(const std::string& name, const std::string& a,
                               const std::string& b) {
    Mechanism::Coordinate& c = b_.coordinate(name, Mechanism::CoordinateType::angle);
    c.of = {-1, points_[a], points_[b]};
    return c;
  }
  void drive_angle(const std::string& a, const std::string& b) {
    angle("theta", a, b).driven = true;
  }
  void drive_along(const std::string& a, const std::string& b, int vector) {
    Mechanism::Coordinate& c = b_.coordinate("s", along);
    c.of = {-1, points_[a], points_[b]};
    c.vector = vector;
    c.driven = true;
  }
  const Vec& at(const std::string& name) { return at_[name]; }
  int index(const std::string& name) { return points_[name]; }
  MechanismBuilder& builder() { return b_; }
  Mechanism take() {
    Mechanism m = b_.take();
    for (std::size_t i = 0; i < m.joints.size(); ++i) m.joints[i].name += "/" + std::to_string(i);
    return m;
  }

 private:
  void pin(int body, const std::string& name) {
    const auto [it, is_new] = last_.try_emplace(name, body);
    if (is_new) return;
    b_.joint(revolute, it->second, body, {points_[name]});
    it->second = body;
  }

  MechanismBuilder b_;
  std::map<std::string, int> points_, last_;  // last body with the point
  std::map<std::string, Vec> at_;
};

/// A crank whose length and nominal pin are exact, so that all of the model is.
struct ExactCrank {
  double length;
  Vec pin;
};
ExactCrank exact_crank(Random& r) {
  static constexpr double triples[][3] = {{3, 4, 5}, {5, 12, 13}, {8, 15, 17}, {20, 21, 29}};
  const auto& t = triples[r.below(4)];
  const double unit = std::ldexp(1, -r.below(3) - 3);
  return {t[2] * unit, {r.sign() * t[0] * unit, t[1] * unit, 0}};
}

/// Crank AB, coupler BC, rocker DC.
Mechanism closed_four_bar(std::string name, double crank, double coupler, double rocker,
                          double base, const Vec& b, const Vec& c) {
  Plane p(std::move(name));
  p.point("A", {0, 0, 0}), p.point("D", {base, 0, 0}), p.point("B", b), p.point("C", c);
  p.ground({"A", "D"});
  p.link("A", "B", crank), p.link("B", "C", coupler), p.link("D", "C", rocker);
  p.drive_angle("A", "B");
  return p.take();
}

}  // namespace

Drawn four_bar(Random& r) {
  const double crank = r.uniform(0.3, 3), base = r.uniform(0.3, 3);
  const Vec b = polar({}, crank, r.uniform(-3, 3)), d{base, 0, 0};
  const double to = length_between(b, d);
  const double sum = to * r.uniform(1.1, 2.5), difference = to * r.uniform(-0.9, 0.9);
  const double coupler = (sum + difference) / 2, rocker = (sum - difference) / 2;
  Mechanism m = closed_four_bar("four_bar", crank, coupler, rocker, base, b,
                                meeting(b, coupler, d, rocker, r.sign()));
  Mechanism::Coordinate psi = m.coordinates.front();
  psi.name = "psi";
  psi.of = {-1, 1, 3};
  psi.driven = false;
  m.coordinates.push_back(psi);
  return {std::move(m), {1.0}, 6.3};
}

Drawn parallelogram(Random& r) {
  const auto [crank, b] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  return {closed_four_bar("parallelogram", crank, base, crank, base, b, {b[0] + base, b[1], 0}),
          {1.0},
          4,
          true};
}

Drawn antiparallelogram(Random& r) {
  const auto [crank, b] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  return {closed_four_bar("antiparallelogram", crank, base, crank, base, b,
                          meeting(b, base, {base, 0, 0}, crank, -1)),
          {1.0},
          4,
          true};
}

Drawn deltoid(Random& r) {
  const auto [base, b] = exact_crank(r);
  const double rocker = base + eighths(r, 1, 16);
  return {closed_four_bar("deltoid", base, rocker, rocker, base, b,
                          meeting(b, rocker, {base, 0, 0}, rocker, r.sign())),
          {1.0},
          4,
          true};
}

Drawn scott_russell(Random& r) {
  Plane p("scott_russell");
  const auto [crank, m] = exact_crank(r);
  p.point("O", {}), p.point("M", m), p.point("C", {0, 2 * m[1], 0});
  p.ground({"O"});
  const int y = p.ground_vector("y", {0, 1, 0});
  p.link("O", "M", crank);
  p.slide("C", p.link("M", "C", crank), "O", y);
  p.drive_angle("O", "M");
  p.angle("phi", "M", "C");
  return {p.take(), {1.0}, 3, true};
}

namespace {

/// Crank OM, rod MC, whose end slides on a line that passes the pivot at a distance.
Mechanism sliding(std::string name, Random& r, bool crank_drives) {
  Plane p(std::move(name));
  const double crank = r.uniform(0.3, 2), rod = crank * r.uniform(1.2, 4);
  const double offset = r.chance(0.3) ? 0 : crank * r.uniform(-0.15, 0.15);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(0.5, 2.6)), e{0, offset, 0};
  const double rise = m[1] - offset, run = std::sqrt(rod * rod - rise * rise);
  p.point("O", o), p.point("E", e), p.point("M", m), p.point("C", {m[0] + run, offset, 0});
  p.ground({"O", "E"});
  const int x = p.ground_vector("x", {1, 0, 0});
  p.link("O", "M", crank);
  p.slide("C", p.link("M", "C", rod), "E", x);
  if (crank_drives) p.drive_angle("O", "M");
  p.drive_along("E", "C", x);
  Mechanism result = p.take();
  result.coordinates.back().driven = !crank_drives;
  return result;
}

}  // namespace

Drawn offset_slider_crank(Random& r) {
  return {sliding("offset_slider_crank", r, true), {1.0}, 6.3};
}

Drawn driven_slider(Random& r) { return {sliding("driven_slider", r, false), {1.0}, 4}; }

Drawn oscillating_block(Random& r) {
  Plane p("oscillating_block");
  const double crank = r.uniform(0.3, 2);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(0.3, 2.8));
  const Vec g{r.chance(0.2) ? crank : crank * r.uniform(0.5, 3), 0, 0};
  p.point("O", o), p.point("G", g), p.point("M", m);
  p.ground({"O", "G"});
  p.link("O", "M", crank);
  const int rod = p.body("rod", {"M"});
  MechanismBuilder& b = p.builder();
  const double length = length_between(m, g);
  const int u = b.vector("u", {(g[0] - m[0]) / length, (g[1] - m[1]) / length, 0});
  b.carry(rod, {}, {u});
  b.joint(revolute_on_slider, rod, MechanismBuilder::ground, {p.index("M"), p.index("G")}, {u});
  p.drive_angle("O", "M");
  Mechanism::Coordinate& s = b.coordinate("s", along);
  s.of = {-1, p.index("M"), p.index("G")};
  s.vector = u;
  return {p.take(), {1.0}, 6.3};
}

Drawn trammel(Random& r) {
  Plane p("trammel");
  const double length = eighths(r, 8, 24), angle = r.uniform(0.3, 1.2);
  p.point("O", {0, 0, 0});
  p.point("P", {length * std::cos(angle), 0, 0});
  p.point("Q", {0, length * std::sin(angle), 0});
  p.ground({"O"});
  const int x = p.ground_vector("x", {1, 0, 0}), y = p.ground_vector("y", {0, 1, 0});
  const int bar = p.link("P", "Q", length);
  p.slide("P", bar, "O", x);
  p.slide("Q", bar, "O", y);
  p.drive_along("O", "P", x);
  return {p.take(), {1.0}, 3, true};
}

Drawn peaucellier(Random& r) {
  Plane p("peaucellier");
  const double crank = eighths(r, 4, 8), arm = 2.5 * crank,
               side = crank * (1.25 + 0.125 * r.below(5));
  const Vec g{crank, 0, 0}, o{0, 0, 0}, c = polar(g, crank, r.uniform(-0.8, 0.8));
  const Vec a = meeting(o, arm, c, side, 1), b = meeting(o, arm, c, side, -1);
  p.point("O", o), p.point("G", g), p.point("P", c), p.point("A", a), p.point("B", b);
  p.point("Q", {a[0] + b[0] - c[0], a[1] + b[1] - c[1], 0});
  p.ground({"O", "G"});
  p.link("G", "P", crank), p.link("O", "A", arm), p.link("O", "B", arm);
  p.link("P", "A", side), p.link("P", "B", side), p.link("Q", "A", side), p.link("Q", "B", side);
  p.drive_angle("G", "P");
  return {p.take(), {1.0}, 3};
}

Drawn chebyshev(Random& r) {
  Plane p("chebyshev");
  const double unit = r.uniform(0.2, 1.5), theta = r.uniform(1.0, 1.9);
  const Vec a{0, 0, 0}, d{4 * unit, 0, 0}, b = polar(a, 5 * unit, theta);
  const Vec c = meeting(b, 2 * unit, d, 5 * unit, r.sign());
  p.point("A", a), p.point("D", d), p.point("B", b), p.point("C", c), p.point("P", middle(b, c));
  p.ground({"A", "D"});
  p.link("A", "B");
  p.body("coupler", {"B", "C", "P"});
  p.link("D", "C");
  p.drive_angle("A", "B");
  return {p.take(), {1.0}, 2};
}

Drawn two_loops(Random& r) {
  Plane p("two_loops");
  const auto [crank, pin] = exact_crank(r);
  const double base = crank + eighths(r, 1, 16);
  p.point("D0", {}), p.point("C0", pin);
  p.ground({"D0"});
  p.link("D0", "C0", crank);
  const int loops = 2 + r.below(3) * r.below(3);
  for (int k = 1; k <= loops; ++k) {
    const std::string c = "C" + std::to_string(k), d = "D" + std::to_string(k);
    p.point(d, {base * k, 0, 0}), p.point(c, {pin[0] + base * k, pin[1], 0});
    p.ground({d});
    p.link("C" + std::to_string(k - 1), c, base), p.link(d, c, crank);
  }
  p.drive_angle("D0", "C0");
  return {p.take(), {1.0}, 4, true};
}

Drawn toggle_press(Random& r) {
  Plane p("toggle_press");
  const double crank = r.uniform(0.2, 0.5), arm = r.uniform(1, 1.5), ram = r.uniform(1, 2);
  const Vec o{0, 0, 0}, m = polar(o, crank, r.uniform(-3, 3));
  const Vec pivot{r.uniform(1.5, 2.5), r.uniform(0.8, 1.2), 0};
  const double to = length_between(m, pivot),
               coupler = std::abs(to - arm) + r.uniform(0.2, 0.9) * 2 * arm;
  const Vec knee = meeting(m, coupler, pivot, arm, r.sign());
  const double run = knee[0] - pivot[0];
  p.point("O", o), p.point("M", m), p.point("K", knee), p.point("D", pivot);
  p.point("R", {pivot[0], knee[1] - std::sqrt(std::max(0.01, ram * ram - run * run)), 0});
  p.ground({"O", "D"});
  const int y = p.ground_vector("y", {0, 1, 0});
  p.link("O", "M"), p.link("M", "K"), p.link("D", "K");
  p.slide("R", p.link("K", "R"), "D", y);
  p.drive_angle("O", "M");
  return {p.take(), {1.0}, 6.3};
}

}  // namespace desmo::promise
