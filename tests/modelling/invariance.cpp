// Names, order, size and place of a description do not matter.

#include <gtest/gtest.h>

#include <random>

#include "tests/accuracy/scenes.h"
#include "tests/modelling/common.h"

namespace desmo::invariance_test {
namespace {

/// The description with its lists in another order; the ground stays first, and the relative order
/// of driven coordinates, which the motions follow.
Mechanism permuted(const Mechanism& mechanism, unsigned seed) {
  std::mt19937 random(seed);
  const auto shuffled = [&](std::size_t n, std::size_t keep) {
    std::vector<int> order(n);
    for (std::size_t i = 0; i < n; ++i) order[i] = static_cast<int>(i);
    std::shuffle(order.begin() + keep, order.end(), random);
    return order;
  };
  const auto moved = [](const std::vector<int>& order) {  // where each went
    std::vector<int> to(order.size());
    for (std::size_t i = 0; i < order.size(); ++i) to[order[i]] = static_cast<int>(i);
    return to;
  };
  const auto take = [](const auto& list, const std::vector<int>& order) {
    auto result = list;
    for (std::size_t i = 0; i < order.size(); ++i) result[i] = list[order[i]];
    return result;
  };
  const auto points = shuffled(mechanism.points.size(), 0),
             vectors = shuffled(mechanism.vectors.size(), 0),
             bodies = shuffled(mechanism.bodies.size(), 1),
             joints = shuffled(mechanism.joints.size(), 0);
  const auto new_point = moved(points), new_vector = moved(vectors), new_body = moved(bodies);
  const auto point = [&](int& p) { p = p < 0 ? p : new_point[p]; };
  const auto vector = [&](int& v) { v = v < 0 ? v : new_vector[v]; };
  Mechanism r = mechanism;
  r.points = take(mechanism.points, points);
  r.vectors = take(mechanism.vectors, vectors);
  r.bodies = take(mechanism.bodies, bodies);
  r.joints = take(mechanism.joints, joints);
  std::ranges::stable_partition(r.coordinates, [](const auto& c) { return c.driven; });
  for (Mechanism::Vector& v : r.vectors)
    if (v.along) point((*v.along)[0]), point((*v.along)[1]);
  for (Mechanism::Body& b : r.bodies) {
    std::ranges::for_each(b.points, point);
    std::ranges::for_each(b.vectors, vector);
  }
  for (Mechanism::Joint& j : r.joints) {
    for (int& b : j.bodies) b = new_body[b];
    std::ranges::for_each(j.points, point);
    std::ranges::for_each(j.vectors, vector);
  }
  for (Mechanism::Coordinate& c : r.coordinates) {
    for (Mechanism::Direction* e : {&c.of, &c.from, &c.towards})
      point(e->from), point(e->to), vector(e->vector);
    vector(c.vector);
    point(c.point);
  }
  return r;
}

/// A mechanism to be solved in other guises, and how its drivers move.
struct Sample {
  Mechanism mechanism;
  std::vector<Motion> motions;
  bool translates = true;
};

/// Planar: a four-bar with a coupler point, driven by a relative angle, and a slider that hangs on
/// it.
Sample planar_sample() {
  Sketch d("planar sample", 2);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
  const int x = d.ground_vector("x", {1, 0, 0});
  const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0}),
            P = d.point("P", {1.5, 3.1, 0}), S = d.point("S", {7, 0.5, 0});
  d.bodies({{"crank", {A, B}}, {"coupler", {B, C, P}}, {"rocker", {D, C}}, {"rod", {C, S}}});
  const int piston = d.body("piston", {S}, {x});
  d.joint(JointType::prismatic, Sketch::ground, piston, {D, S}, {x});
  d.angle("theta", line(A, B), {x}).driven = true;
  d.angle("mu", line(C, B), line(C, D));
  d.distance("AP", A, P);
  return {d.release_pinned(), turning};
}

/// Spatial: a crank about z and a rocker about x, joined by a rod with spherical ends (RSSR).
Sample spatial_sample() {
  Sketch d("spatial sample", 3);
  const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 3, 0.5});
  const int x = d.ground_vector("x", {1, 0, 0}), y = d.ground_vector("y", {0, 1, 0}),
            z = d.ground_vector("z", {0, 0, 1}), axis = d.ground_vector("axis", {1, 0, 0});
  const int B = d.point("B", polar(1, 0.5)), C = d.point("C", {4, 3, 3});
  const int W = d.point("W", {4.5, 3.5, 2});
  const int crank = d.body("crank", {A, B}, {z}), rod = d.body("rod", {B, C}),
            rocker = d.body("rocker", {D, C, W}, {axis});
  d.joint(JointType::revolute, Sketch::ground, crank, {A}, {z});
  d.joint(JointType::spherical, crank, rod, {B});
  d.joint(JointType::spherical, rod, rocker, {C});
  d.joint(JointType::revolute, Sketch::ground, rocker, {D}, {axis});
  d.spatial_angle("theta", line(A, B), x, y).driven = true;
  d.distance("AW", A, W);
  return {d.release(), {Polynomial{{0.5, 1}}}};
}

Sample truck_sample() {
  Scene s = truck_suspension(1);
  return {s.mechanism, s.motions, false};
}

/// The rotation about z, then (space) about x.
Vec rotated(const Vec& p, int dimension) {
  const Vec q{0.6 * p[0] - 0.8 * p[1], 0.8 * p[0] + 0.6 * p[1], p[2]};
  if (dimension == 2) return q;
  const double c = std::cos(0.9), s = std::sin(0.9);
  return {q[0], c * q[1] - s * q[2], s * q[1] + c * q[2]};
}

struct Guise : testing::TestWithParam<int> {
  Sample sample = GetParam() == 0   ? planar_sample()
                  : GetParam() == 1 ? spatial_sample()
                                    : truck_sample();
  std::vector<double> times = instants(0.5);

  /// Structure is the same, and every point and length is the image of the original's.
  template <class Image>
  void expect_image(const Mechanism& other, const std::vector<Motion>& motions, double scale,
                    Image&& image) {
    const Model original = model_mechanism(sample.mechanism, sample.motions).model;
    const Model changed = model_mechanism(other, motions).model;
    EXPECT_EQ(changed.coordinates(), original.coordinates());
    EXPECT_EQ(changed.structural_groups(), original.structural_groups());
    int rows[2] = {0, 0};
    for (const Constraint& c : original.constraints) rows[0] += kept_rows(c);
    for (const Constraint& c : changed.constraints) rows[1] += kept_rows(c);
    EXPECT_EQ(rows[1], rows[0]);

    const Solved a(original, times),
        b(changed, times, "global_automatic_eigen", 1e-13 * std::max(1.0, scale * scale));
    for (int k = 0; k < a.instants() && !HasFailure(); k += 10) {
      for (const Mechanism::Point& p : sample.mechanism.points)
        expect_near(1 / scale * b.position(k, p.name), image(a.position(k, p.name)), 1e-8, p.name);
      for (const Mechanism::Coordinate& c : sample.mechanism.coordinates) {
        if (c.type == CoordinateType::angle)
          expect_same_angle(b.scalar(k, c.name), a.scalar(k, c.name), 1e-8, c.name);
        else
          EXPECT_NEAR(b.scalar(k, c.name) / scale, a.scalar(k, c.name), 1e-8) << c.name;
      }
    }
  }
};

TEST_P(Guise, NamesOfBodiesDoNotMatter) {
  Mechanism mechanism = sample.mechanism;
  for (std::size_t b = 1; b < mechanism.bodies.size(); ++b)
    mechanism.bodies[b].name = "body " + std::to_string(mechanism.bodies.size() - b);
  for (std::size_t j = 0; j < mechanism.joints.size(); ++j)
    mechanism.joints[j].name = "j" + std::to_string(j);
  expect_image(mechanism, sample.motions, 1, std::identity{});
}

TEST_P(Guise, OrderDoesNotMatter) {
  for (unsigned seed = 1; seed <= 6; ++seed)
    expect_image(permuted(sample.mechanism, seed), sample.motions, 1, std::identity{});
}

TEST_P(Guise, OrderWithinBodiesAndJointsDoesNotMatter) {
  // What a body is built on changes, so that the equations do; their number does not.
  Mechanism mechanism = sample.mechanism;
  for (Mechanism::Body& b : mechanism.bodies) std::ranges::reverse(b.points);
  for (Mechanism::Joint& j : mechanism.joints) {
    using enum Mechanism::JointType;
    std::swap(j.bodies[0], j.bodies[1]);
    if (j.type == prismatic || j.type == cylindrical) std::swap(j.points[0], j.points[1]);
    if (j.type == universal) std::swap(j.vectors[0], j.vectors[1]);
  }
  expect_image(mechanism, sample.motions, 1, std::identity{});
}

TEST_P(Guise, TheUnitOfLengthDoesNotMatter) {
  for (const double scale : {1e3, 1e-3}) {
    Scene scene;
    scene.mechanism = sample.mechanism;
    scene.motions = sample.motions;
    scene = enlarged(std::move(scene), scale);
    expect_image(scene.mechanism, scene.motions, scale, std::identity{});
  }
}

TEST_P(Guise, WhereItStandsDoesNotMatter) {
  if (!sample.translates) GTEST_SKIP() << "its heights are measured from the origin";
  const auto image = [&](const Vec& p) {
    return rotated(p, sample.mechanism.dimension) + Vec{3, -2, 0};
  };
  Mechanism mechanism = sample.mechanism;
  for (Mechanism::Point& p : mechanism.points) p.position = image(p.position);
  for (Mechanism::Vector& v : mechanism.vectors)
    v.direction = rotated(v.direction, mechanism.dimension);
  expect_image(mechanism, sample.motions, 1, image);
}

INSTANTIATE_TEST_SUITE_P(Samples, Guise, testing::Values(0, 1, 2), [](const auto& info) {
  return std::string(info.param == 0 ? "planar" : info.param == 1 ? "spatial" : "truck");
});

TEST(Invariance, ADriverOfASharedPointIsThatOfTheFirstBodyThatCarriesIt) {
  // B is on crank and coupler. Listed first, the crank is driven and a group of its own; listed
  // second, it is solved with the coupler. The motion is the same.
  const auto mechanism = [](bool crank_first) {
    Sketch d("by abscissa", 2);
    const int A = d.ground_point("A", {0, 0, 0}), D = d.ground_point("D", {4, 0, 0});
    const int B = d.point("B", polar(1, 1)), C = d.point("C", {3.2, 2.9, 0});
    if (crank_first) d.body("crank", {A, B});
    d.bodies({{"coupler", {B, C}}, {"rocker", {D, C}}});
    if (!crank_first) d.body("crank", {A, B});
    d.component("Bx", B, 0).driven = true;
    return d.release_pinned();
  };
  const std::vector<Motion> abscissa{Polynomial{{std::cos(1.0), -0.5}}};
  const std::vector<double> times = instants(0.5);
  const Solved a(mechanism(true), abscissa, times), b(mechanism(false), abscissa, times);
  EXPECT_EQ(a.model().structural_groups(), 2);
  EXPECT_EQ(a.model().groups[0].bodies, std::vector<std::string>{"crank"});
  EXPECT_EQ(b.model().structural_groups(), 1);
  for (int k = 0; k < a.instants() && !HasFailure(); ++k)
    expect_near(b.position(k, "C"), a.position(k, "C"), 1e-11, "C");
}

}  // namespace
}  // namespace desmo::invariance_test
