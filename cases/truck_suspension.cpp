#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

#include "cases/cases.h"

namespace desmo {

namespace {

using Vec3 = std::array<double, 3>;
using Scalar = std::array<double, 1>;

Vec3 operator+(const Vec3& a, const Vec3& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec3 operator-(const Vec3& a, const Vec3& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec3 operator-(const Vec3& a) { return {-a[0], -a[1], -a[2]}; }
double dot(const Vec3& a, const Vec3& b) { return vec::dot<3>(a.data(), b.data()); }
Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vec3 unit(const Vec3& a) {
  const double n = std::sqrt(dot(a, a));
  return {a[0] / n, a[1] / n, a[2] / n};
}

constexpr Vec3 x_axis{1, 0, 0}, y_axis{0, 1, 0}, z_axis{0, 0, 1};

/// Builds one axle after the other into a mechanism; positions are relative to the axle's origin.
class Builder {
 public:
  explicit Builder(Mechanism& mechanism) : m_(mechanism) {
    const GroupId ground = m_.add_group("ground", {"1"});
    m_.groups[ground].constant = true;
    const EntityId lateral = m_.add_fixed(EntityKind::vector, "chassis lateral", y_axis);
    y1_ = m_.add(EntityKind::vector, "y1", y_axis, ground);
    m_.constrain<Rigid<3, 0>>(ground, "y1 on the chassis", {y1_, lateral});
    m_.groups[ground].entities = {y1_};
  }

  void add_axle(int a) {
    axle_ = "axle" + std::to_string(a + 1) + "/";
    origin_ = {-1.4 * a, 0, 0.5};
    add_axle_group(a);
    add_stabiliser("SG-II", "6", "8", +1);
    add_stabiliser("SG-III", "7", "9", -1);
    add_damper("SG-IV", "10", "11", +1);
    add_damper("SG-V", "12", "13", -1);
  }

 private:
  // Nominal positions relative to the axle's origin.
  static constexpr Vec3 wl_{0, 1, 0}, wr_{0, -1, 0}, s_{0, 0, 0.25}, r_{0.6, 0, 0.30};

  GroupId group(const std::string& name, std::vector<std::string> bodies) {
    for (std::string& b : bodies) b.insert(0, axle_);
    return g_ = m_.add_group(axle_ + name, std::move(bodies));
  }
  EntityId point(const std::string& name, const Vec3& at) {
    return m_.add(EntityKind::point, axle_ + name, origin_ + at, g_);
  }
  EntityId fixed_point(const std::string& name, const Vec3& at) {
    return m_.add_fixed(EntityKind::point, axle_ + name, origin_ + at);
  }
  EntityId vector(const std::string& name, const Vec3& direction) {
    return m_.add(EntityKind::vector, axle_ + name, direction, g_);
  }
  EntityId scalar(EntityKind kind, const std::string& name, double value) {
    return m_.add(kind, axle_ + name, Scalar{value}, g_);
  }

  /// A constant distance between two points.
  void length(const std::string& name, EntityId a, EntityId b, const Vec3& nominal) {
    m_.constrain<Length<3>>(g_, axle_ + name, {a, b}, {dot(nominal, nominal)});
  }
  /// u is a unit vector normal to a vector and to the segment from a to b.
  void normal(const std::string& name, EntityId u, EntityId v, EntityId a, EntityId b) {
    m_.constrain<Unit<3>>(g_, axle_ + name + " unit", {u});
    m_.constrain<Dot<3>>(g_, axle_ + name + " normal to vector", {u, v}, {0});
    m_.constrain<Projection<3>>(g_, axle_ + name + " normal to segment", {u, a, b}, {0});
  }
  /// u is a unit vector normal to two vectors.
  void normal(const std::string& name, EntityId u, EntityId v, EntityId w) {
    m_.constrain<Unit<3>>(g_, axle_ + name + " unit", {u});
    m_.constrain<Dot<3>>(g_, axle_ + name + " normal to first", {u, v}, {0});
    m_.constrain<Dot<3>>(g_, axle_ + name + " normal to second", {u, w}, {0});
  }
  /// A point of the rigid axle: WL plus constant multiples of x2, y2, z2; zero ones are left out.
  void on_axle(const std::string& name, EntityId p, const Vec3& at) {
    const Vec3 offset = at - wl_;
    const std::string full = axle_ + name + " on the axle";
    const bool x = offset[0] != 0, z = offset[2] != 0;
    if (x && z)
      m_.constrain<Rigid<3, 3>>(g_, full, {p, WL_, x2_, y2_, z2_}, offset);
    else if (x)
      m_.constrain<Rigid<3, 2>>(g_, full, {p, WL_, x2_, y2_}, {offset[0], offset[1]});
    else if (z)
      m_.constrain<Rigid<3, 2>>(g_, full, {p, WL_, y2_, z2_}, {offset[1], offset[2]});
    else
      m_.constrain<Rigid<3, 1>>(g_, full, {p, WL_, y2_}, {offset[1]});
  }

  void add_axle_group(int a) {
    group("SG-I", {"2", "3", "4", "5"});
    const Vec3 c4{0, 0.5, -0.15}, c5{0, -0.5, -0.15}, g4{0.8, 0.45, -0.15}, g5{0.8, -0.45, -0.15};
    const Vec3 nominal_u4 = unit(cross(z_axis, c4 - g4)), nominal_u5 = unit(cross(y_axis, c5 - g5));

    WL_ = point("WL", wl_);
    x2_ = vector("x2", x_axis);
    y2_ = vector("y2", y_axis);
    z2_ = vector("z2", z_axis);
    const EntityId S = point("S", s_), C4 = point("C4", c4), C5 = point("C5", c5);
    const EntityId WR = point("WR", wr_);
    const EntityId n3 = vector("n3", unit(cross(y_axis, s_ - r_)));
    const EntityId u4 = vector("u4", nominal_u4);
    const EntityId n4 = vector("n4", unit(cross(c4 - g4, nominal_u4)));
    const EntityId u5 = vector("u5", nominal_u5);
    const EntityId n5 = vector("n5", unit(cross(c5 - g5, nominal_u5)));
    const EntityId zL = scalar(EntityKind::distance, "zL", 0.5);
    const EntityId zR = scalar(EntityKind::distance, "zR", 0.5);
    const EntityId R = fixed_point("R", r_), G4 = fixed_point("G4", g4), G5 = fixed_point("G5", g5);
    m_.groups[g_].entities = {S,   C4,  C5, WL_, WR, R,  G4, G5, y1_, x2_,
                              y2_, z2_, n3, u4,  n4, u5, n5, zL, zR};

    m_.constrain<Unit<3>>(g_, axle_ + "x2 unit", {x2_});
    m_.constrain<Unit<3>>(g_, axle_ + "y2 unit", {y2_});
    m_.constrain<Unit<3>>(g_, axle_ + "z2 unit", {z2_});
    m_.constrain<Dot<3>>(g_, axle_ + "x2 normal to y2", {x2_, y2_}, {0});
    m_.constrain<Dot<3>>(g_, axle_ + "x2 normal to z2", {x2_, z2_}, {0});
    m_.constrain<Dot<3>>(g_, axle_ + "y2 normal to z2", {y2_, z2_}, {0});
    on_axle("S", S, s_);
    on_axle("C4", C4, c4);
    on_axle("C5", C5, c5);
    on_axle("WR", WR, wr_);
    // upper arm, body 3
    length("arm length", R, S, s_ - r_);
    m_.constrain<Projection<3>>(g_, axle_ + "arm normal to y1", {y1_, R, S}, {0});
    normal("n3", n3, y1_, R, S);
    // lower rods, bodies 4 and 5
    length("rod 4 length", G4, C4, c4 - g4);
    normal("u4", u4, z2_, G4, C4);
    normal("n4", n4, u4, G4, C4);
    length("rod 5 length", G5, C5, c5 - g5);
    normal("u5", u5, y2_, G5, C5);
    normal("n5", n5, u5, G5, C5);
    // wheel heights
    m_.constrain<Component<3, 2>>(g_, axle_ + "height of WL", {WL_, zL});
    m_.constrain<Component<3, 2>>(g_, axle_ + "height of WR", {WR, zR});

    constexpr double turn = 2 * std::numbers::pi;
    m_.drive(zL, Harmonic{0.5, 0.05, turn * 1.0, -0.3 * a});
    m_.drive(zR, Harmonic{0.5, 0.05, turn * 1.3, 0.7 - 0.3 * a});
  }

  /// Lever and link of the stabiliser bar; side is +1 on the left.
  void add_stabiliser(const std::string& name, const std::string& lever, const std::string& link,
                      int side) {
    group(name, {lever, link});
    const Vec3 a{-0.2, side * 0.6, 0}, b{-0.5, side * 0.6, 0.05}, g{-0.5, side * 0.65, 0.45};
    const Vec3 arm = b - a, rod = b - g;
    const Vec3 nominal_e = unit(arm), nominal_u = unit(cross(nominal_e, rod));
    const double arm_length = std::sqrt(dot(arm, arm));

    const EntityId A = point("A" + lever, a), B = point("B" + lever, b);
    const EntityId e = vector("e" + lever, nominal_e);
    const EntityId n = vector("n" + lever, unit(cross(y_axis, arm)));
    const EntityId u = vector("u" + link, nominal_u);
    const EntityId m = vector("n" + link, unit(cross(rod, nominal_u)));
    const EntityId phi = scalar(EntityKind::angle, "phi" + lever, std::atan2(arm[2], -arm[0]));
    const EntityId G = fixed_point("G" + link, g);
    m_.groups[g_].entities = {A, B, G, y2_, e, n, u, m, phi};

    on_axle("A" + lever, A, a);
    length("lever " + lever + " length", A, B, arm);
    m_.constrain<Projection<3>>(g_, axle_ + "lever " + lever + " normal to y2", {y2_, A, B}, {0});
    normal("n" + lever, n, y2_, A, B);
    m_.constrain<Rigid<3, 1>>(g_, axle_ + "e" + lever + " along the lever", {B, A, e},
                              {arm_length});
    m_.constrain<FrameAngle>(g_, axle_ + "angle of lever " + lever, {x2_, z2_, A, B, phi});
    length("link " + link + " length", G, B, rod);
    normal("u" + link, u, e, G, B);
    normal("n" + link, m, u, G, B);
  }

  /// Rod and tube of a damper; side is +1 on the left.
  void add_damper(const std::string& name, const std::string& rod, const std::string& tube,
                  int side) {
    group(name, {rod, tube});
    const Vec3 a{0.15, side * 0.7, 0.05}, t{0.1, side * 0.6, 0.65};
    const Vec3 nominal_d = unit(t - a), nominal_u = unit(cross(nominal_d, x_axis));
    const Vec3 nominal_n = unit(cross(nominal_d, nominal_u));

    const EntityId A = point("A" + rod, a);
    const EntityId d = vector("d" + rod, nominal_d), u = vector("u" + rod, nominal_u);
    const EntityId n = vector("n" + rod, nominal_n), m = vector("n" + tube, -nominal_n);
    const EntityId s = scalar(EntityKind::distance, "s" + rod, std::sqrt(dot(t - a, t - a)));
    const EntityId T = fixed_point("T" + tube, t);
    m_.groups[g_].entities = {A, T, x2_, d, u, n, m, s};

    on_axle("A" + rod, A, a);
    m_.constrain<Along<3>>(g_, axle_ + "length of damper " + rod, {A, T, d, s});
    m_.constrain<Unit<3>>(g_, axle_ + "d" + rod + " unit", {d});
    normal("u" + rod, u, d, x2_);
    normal("n" + rod, n, d, u);
    normal("n" + tube, m, d, u);
  }

  Mechanism& m_;
  std::string axle_;  ///< prefix of the names of the axle under construction
  Vec3 origin_{};     ///< its origin
  GroupId g_ = 0;     ///< the group under construction
  EntityId y1_ = 0, WL_ = 0, x2_ = 0, y2_ = 0, z2_ = 0;
};

}  // namespace

Mechanism truck_suspension(int axles) {
  if (axles < 1 || axles > 100'000)
    throw std::invalid_argument("truck_suspension: from 1 to 100000 axles, not " +
                                std::to_string(axles));
  Mechanism m;
  m.name = "truck_suspension";
  Builder builder(m);
  for (int a = 0; a < axles; ++a) builder.add_axle(a);
  validate(m);
  return m;
}

}  // namespace desmo
