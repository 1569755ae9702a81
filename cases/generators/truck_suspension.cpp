#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "cases/generators/cases.h"
#include "cases/mechanism/builder.h"
#include "cases/numbers/space.h"

namespace desmo {

namespace {

using Vec = Mechanism::Vec;
using enum Mechanism::JointType;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator-(const Vec& a) { return {-a[0], -a[1], -a[2]}; }
Vec unit(const Vec& a) {
  const double n = std::sqrt(dot(a, a));
  return {a[0] / n, a[1] / n, a[2] / n};
}
/// Returns the unit vector along a × b.
Vec normal(const Vec& a, const Vec& b) { return unit(cross(a, b)); }

constexpr Vec x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

/// Builder of the truck suspension, one axle after the other. Positions are relative to the origin
/// of the axle under construction.
class Builder {
 public:
  Builder() : builder_("truck_suspension", 3), y1_(builder_.vector("y1", y_axis)) {
    builder_.carry(MechanismBuilder::ground, {}, {y1_});
  }

  void add_axle(int a) {
    axle_ = "axle" + std::to_string(a + 1) + "/";
    origin_ = {-1.4 * a, 0, 0.5};
    add_axle_and_arms(a);
    add_stabiliser("6", "8", +1);
    add_stabiliser("7", "9", -1);
    add_damper("10", "11", +1);
    add_damper("12", "13", -1);
  }

  Scene scene() {
    return {"truck_suspension", builder_.release(), std::move(motions_), time_grid(30, 0.01)};
  }

 private:
  int point(const std::string& name, const Vec& at) {
    return builder_.point(axle_ + name, origin_ + at);
  }
  int ground_point(const std::string& name, const Vec& at) {
    const int p = point(name, at);
    builder_.carry(MechanismBuilder::ground, {p});
    return p;
  }
  int vector(const std::string& name, const Vec& direction) {
    return builder_.vector(axle_ + name, direction);
  }

  /// Adds bodies 2 to 5, the rigid axle, the upper arm and the lower rods, and drives both wheels.
  void add_axle_and_arms(int a) {
    const Vec s{0, 0, 0.25}, c4{0, 0.5, -0.15}, c5{0, -0.5, -0.15};
    const Vec r{0.6, 0, 0.30}, g4{0.8, 0.45, -0.15}, g5{0.8, -0.45, -0.15};
    const Vec nominal_u4 = normal(z_axis, c4 - g4), nominal_u5 = normal(y_axis, c5 - g5);

    const int WL = point("WL", {0, 1, 0}), S = point("S", s);
    const int C4 = point("C4", c4), C5 = point("C5", c5), WR = point("WR", {0, -1, 0});
    const int R = ground_point("R", r), G4 = ground_point("G4", g4), G5 = ground_point("G5", g5);
    x2_ = vector("x2", x_axis);
    y2_ = vector("y2", y_axis);
    z2_ = vector("z2", z_axis);
    const int n3 = vector("n3", normal(y_axis, s - r));
    const int u4 = vector("u4", nominal_u4), n4 = vector("n4", normal(c4 - g4, nominal_u4));
    const int u5 = vector("u5", nominal_u5), n5 = vector("n5", normal(c5 - g5, nominal_u5));

    rigid_axle_ = builder_.body(axle_ + "2", {WL, S, C4, C5, WR}, {x2_, y2_, z2_});
    const int arm = builder_.body(axle_ + "3", {R, S}, {y1_, n3});
    const int rod4 = builder_.body(axle_ + "4", {G4, C4}, {u4, n4});
    const int rod5 = builder_.body(axle_ + "5", {G5, C5}, {u5, n5});
    builder_.joint(spherical, rigid_axle_, arm, {S});
    builder_.joint(revolute, MechanismBuilder::ground, arm, {R}, {y1_});
    builder_.joint(universal, rigid_axle_, rod4, {C4}, {z2_, u4});
    builder_.joint(universal, rigid_axle_, rod5, {C5}, {y2_, u5});
    builder_.joint(spherical, MechanismBuilder::ground, rod4, {G4});
    builder_.joint(spherical, MechanismBuilder::ground, rod5, {G5});

    constexpr double turn = 2 * std::numbers::pi;
    drive_height("zL", WL, {0.05, turn * 1.0, -0.3 * a});
    drive_height("zR", WR, {0.05, turn * 1.3, 0.7 - 0.3 * a});
  }

  void drive_height(const std::string& name, int wheel_centre, const HarmonicSum::Term& term) {
    builder_.component(axle_ + name, wheel_centre, 2).driven = true;
    motions_.push_back(HarmonicSum{0.5, {term}});
  }

  /// Adds the lever and the link of the stabiliser bar; side is +1 on the left, −1 on the right.
  void add_stabiliser(const std::string& lever, const std::string& link, int side) {
    const Vec a{-0.2, side * 0.6, 0}, b{-0.5, side * 0.6, 0.05}, g{-0.5, side * 0.65, 0.45};
    const Vec nominal_e = unit(b - a), nominal_u = normal(nominal_e, b - g);

    const int A = point("A" + lever, a), B = point("B" + lever, b);
    const int G = ground_point("G" + link, g);
    const int e = builder_.vector_along(axle_ + "e" + lever, nominal_e, A, B);
    const int n = vector("n" + lever, normal(y_axis, b - a));
    const int u = vector("u" + link, nominal_u), m = vector("n" + link, normal(b - g, nominal_u));
    builder_.carry(rigid_axle_, {A});
    const int lever_body = builder_.body(axle_ + lever, {A, B}, {y2_, e, n});
    const int link_body = builder_.body(axle_ + link, {B, G}, {u, m});
    builder_.joint(revolute, rigid_axle_, lever_body, {A}, {y2_});
    builder_.joint(universal, lever_body, link_body, {B}, {e, u});
    builder_.joint(spherical, MechanismBuilder::ground, link_body, {G});

    builder_.angle(axle_ + "phi" + lever, {-1, A, B}, {x2_}, {z2_}).opposite = true;
  }

  /// Adds the rod and the tube of a damper; side is +1 on the left, −1 on the right.
  void add_damper(const std::string& rod, const std::string& tube, int side) {
    const Vec a{0.15, side * 0.7, 0.05}, t{0.1, side * 0.6, 0.65};
    const Vec nominal_d = unit(t - a), nominal_u = normal(nominal_d, x_axis);
    const Vec nominal_n = normal(nominal_d, nominal_u);

    const int A = point("A" + rod, a), T = ground_point("T" + tube, t);
    const int axis = vector("d" + rod, nominal_d), u = vector("u" + rod, nominal_u);
    const int n = vector("n" + rod, nominal_n), m = vector("n" + tube, -nominal_n);
    builder_.carry(rigid_axle_, {A});
    const int rod_body = builder_.body(axle_ + rod, {A}, {axis, u, n});
    const int tube_body = builder_.body(axle_ + tube, {T}, {axis, u, m});
    builder_.joint(universal, rigid_axle_, rod_body, {A}, {x2_, u});
    builder_.joint(prismatic, rod_body, tube_body, {A, T}, {axis, u});
    builder_.joint(spherical, MechanismBuilder::ground, tube_body, {T});

    builder_.along(axle_ + "s" + rod, A, T, axis);
  }

  MechanismBuilder builder_;
  int y1_;
  std::vector<Motion> motions_;
  std::string axle_;  ///< prefix of the names of the axle under construction
  Vec origin_{};      ///< origin of the axle under construction
  int rigid_axle_ = 0, x2_ = 0, y2_ = 0, z2_ = 0;
};

}  // namespace

Scene truck_suspension(int axles) {
  if (axles < 1 || axles > 100'000)
    throw std::invalid_argument("truck_suspension: from 1 to 100000 axles, not " +
                                std::to_string(axles));
  Builder builder;
  for (int a = 0; a < axles; ++a) builder.add_axle(a);
  return builder.scene();
}

}  // namespace desmo
