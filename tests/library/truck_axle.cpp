#include <array>
#include <string>

#include "tests/library/newton.h"
#include "tests/library/solutions.h"

namespace desmo::exact {

namespace {

const Vec3 origin{{0, 0, 0.5L}};

Vec3 from_origin(Real x, Real y, Real z) { return origin + Vec3{{x, y, z}}; }

/// The rigid axle, whose frame is drawn as that of the chassis. Known: wheel heights, the arm's
/// length and its being held in the plane of its hinge, two rods.
Body solve_axle(Jet zL, Jet zR) {
  const Vec3 R = from_origin(0.6L, 0, 0.3L), G4 = from_origin(0.8L, 0.45L, -0.15L),
             G5 = from_origin(0.8L, -0.45L, -0.15L);
  const auto residual = [&](const std::array<Jet, 6>& x) {
    const Body axle = body_at(x);
    const Vec3 arm = axle.point({{0, 0, 0.25L}}) - R, rod4 = axle.point({{0, 0.5L, -0.15L}}) - G4,
               rod5 = axle.point({{0, -0.5L, -0.15L}}) - G5;
    constexpr Real arm2 = 0.6L * 0.6L + 0.05L * 0.05L, rod2 = 0.8L * 0.8L + 0.05L * 0.05L;
    return std::array{axle.point({{0, 1, 0}})[2] - zL, axle.point({{0, -1, 0}})[2] - zR,
                      dot(arm, arm) - Jet(arm2),       arm[1],
                      dot(rod4, rod4) - Jet(rod2),     dot(rod5, rod5) - Jet(rod2)};
  };
  return body_at(solve<6>({0, 0, 0.5L, 0, 0, 0}, residual));
}

/// Lever and link: the link's length gives a cos φ + b sin φ = c.
void add_stabiliser(Solution& s, const Body& axle, int side, const std::string& lever,
                    const std::string& link) {
  const Vec3 x2 = axle.direction(x_axis), y2 = axle.direction(y_axis), z2 = axle.direction(z_axis);
  const Vec3 A = axle.point({{-0.2L, side * 0.6L, 0}}), G = from_origin(-0.5L, side * 0.65L, 0.45L);
  const Jet L = sqrt(Jet(0.3L * 0.3L + 0.05L * 0.05L));
  constexpr Real link2 = 0.05L * 0.05L + 0.4L * 0.4L;
  const Vec3 w = A - G;
  const Jet phi =
      angle_with(-Jet(2) * L * dot(w, x2), Jet(2) * L * dot(w, z2), Jet(link2) - L * L - dot(w, w));
  const Vec3 e = sin(phi) * z2 - cos(phi) * x2, B = A + L * e;
  const Vec3 u = unit(cross(e, B - G));
  s.insert({{"A" + lever, A},
            {"B" + lever, B},
            {"G" + link, G},
            {"e" + lever, e},
            {"n" + lever, cross(y2, e)},
            {"u" + link, u},
            {"n" + link, unit(cross(B - G, u))},
            {"phi" + lever, phi}});
}

void add_damper(Solution& s, const Body& axle, int side, const std::string& rod,
                const std::string& tube) {
  const Vec3 A = axle.point({{0.15L, side * 0.7L, 0.05L}}),
             T = from_origin(0.1L, side * 0.6L, 0.65L);
  const Vec3 d = unit(T - A), u = unit(cross(d, axle.direction(x_axis))), n = cross(d, u);
  s.insert({{"A" + rod, A},
            {"T" + tube, T},
            {"d" + rod, d},
            {"u" + rod, u},
            {"n" + rod, n},
            {"n" + tube, Jet(-1) * n},
            {"s" + rod, norm(T - A)}});
}

}  // namespace

/// The pose of the axle from six equations; everything else hangs on it in closed form.
Solution truck_axle(double time) {
  const Jet t = Jet::time(time);
  const Jet zL = Jet(0.5L) + Jet(0.05L) * sin(Jet(2 * pi) * t);
  const Jet zR = Jet(0.5L) + Jet(0.05L) * sin(Jet(2.6L * pi) * t + Jet(0.7L));
  const Body axle = solve_axle(zL, zR);
  const Vec3 y2 = axle.direction(y_axis), z2 = axle.direction(z_axis);
  const Vec3 S = axle.point({{0, 0, 0.25L}}), R = from_origin(0.6L, 0, 0.3L);
  const Vec3 C4 = axle.point({{0, 0.5L, -0.15L}}), G4 = from_origin(0.8L, 0.45L, -0.15L);
  const Vec3 C5 = axle.point({{0, -0.5L, -0.15L}}), G5 = from_origin(0.8L, -0.45L, -0.15L);
  const Vec3 u4 = unit(cross(z2, C4 - G4)), u5 = unit(cross(y2, C5 - G5));

  Solution s{{"S", S}, {"R", R}, {"C4", C4}, {"G4", G4}, {"C5", C5}, {"G5", G5}};
  s.insert(
      {{"y1", y_axis}, {"y2", y2}, {"z2", z2}, {"u4", u4}, {"u5", u5}, {"zL", zL}, {"zR", zR}});
  s.insert({{"WL", axle.point({{0, 1, 0}})},
            {"WR", axle.point({{0, -1, 0}})},
            {"x2", axle.direction(x_axis)},
            {"n3", unit(cross(y_axis, S - R))},
            {"n4", unit(cross(C4 - G4, u4))},
            {"n5", unit(cross(C5 - G5, u5))}});
  add_stabiliser(s, axle, +1, "6", "8");
  add_stabiliser(s, axle, -1, "7", "9");
  add_damper(s, axle, +1, "10", "11");
  add_damper(s, axle, -1, "12", "13");
  return s;
}

}  // namespace desmo::exact
