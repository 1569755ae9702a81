#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "cases/mechanism/builder.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "tests/refusal.h"

namespace desmo {

using Vec = Mechanism::Vec;
using JointType = Mechanism::JointType;
using CoordinateType = Mechanism::CoordinateType;

/// The motion of a driver at rest at 1.
inline const Motion still = Polynomial{{1}};

inline Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
inline Vec operator-(const Vec& a, const Vec& b) { return a + -1.0 * b; }
inline double norm(const Vec& a) { return std::sqrt(dot(a, a)); }
inline Vec unit(const Vec& a) { return 1 / norm(a) * a; }
inline Vec polar(double r, double angle) { return {r * std::cos(angle), r * std::sin(angle), 0}; }
/// Returns the angle from a to b [rad], counter-clockwise.
inline double turn(const Vec& a, const Vec& b) { return std::atan2(cross(a, b)[2], dot(a, b)); }

/// A MechanismBuilder with shorthands for tests. A joint takes points and vectors that both bodies
/// already carry.
class Sketch : public MechanismBuilder {
 public:
  using MechanismBuilder::MechanismBuilder;

  int ground_point(const std::string& name, const Vec& at) {
    const int p = point(name, at);
    carry(ground, {p});
    return p;
  }
  int ground_vector(const std::string& name, const Vec& direction) {
    const int v = vector(name, direction);
    carry(ground, {}, {v});
    return v;
  }
  void weld(int a, int b) { joint(JointType::fixed, a, b, {}); }

  /// A body by its name and what it carries.
  struct Carrier {
    std::string name;
    std::vector<int> points, vectors = {};
  };
  void bodies(const std::vector<Carrier>& list) {
    for (const auto& [name, points, vectors] : list) body(name, points, vectors);
  }
  /// Returns the mechanism, in which bodies that share a point turn about it, and about these
  /// vectors in space: each body is joined to the one before it.
  Mechanism release_pinned(const std::vector<int>& axis = {}) {
    Mechanism mechanism = release();
    std::vector<int> last(mechanism.points.size(), -1);
    for (int b = 0; b < static_cast<int>(mechanism.bodies.size()); ++b)
      for (const int p : mechanism.bodies[b].points)
        if (const int before = std::exchange(last[p], b); before >= 0)
          mechanism.joints.push_back({{}, JointType::revolute, {before, b}, {p}, axis});
    name_joints(mechanism);
    return mechanism;
  }

  /// In space: of the projection onto the plane of vectors `from` and `towards`.
  Mechanism::Coordinate& spatial_angle(const std::string& name, const Mechanism::Direction& of,
                                       int from, int towards) {
    return angle(name, of, {from}, {towards});
  }
  Mechanism::Coordinate& distance(const std::string& name, int from, int to) {
    Mechanism::Coordinate& c = coordinate(name, CoordinateType::distance);
    c.of = {-1, from, to};
    return c;
  }
};

/// Returns the line from one point to another.
inline Mechanism::Direction line(int from, int to) { return {-1, from, to}; }

/// A model solved at given instants. The constructor expects every step to succeed.
class Solved {
 public:
  Solved(Model model, std::span<const double> times, std::string_view id = "global_automatic_eigen",
         double tolerance = 1e-13)
      : m_(std::move(model)), times_(times.begin(), times.end()) {
    const auto f = make_formulation(find_variant(id), m_, Settings{tolerance, 50});
    for (const double t : times) {
      const Summary s = f->step(t);
      EXPECT_TRUE(s.ok()) << id << ": " << describe(s, m_);
      q_.emplace_back(f->q().begin(), f->q().end());
      qd_.emplace_back(f->qd().begin(), f->qd().end());
      qdd_.emplace_back(f->qdd().begin(), f->qdd().end());
    }
  }
  Solved(const Mechanism& mechanism, const std::vector<Motion>& motions,
         std::span<const double> times)
      : Solved(model_mechanism(mechanism, motions).model, times) {}

  const Model& model() const { return m_; }
  int instants() const { return static_cast<int>(q_.size()); }
  double time(int instant) const { return times_[instant]; }

  /// Return the values of a point or vector; the first component for a scalar.
  Vec position(int instant, const std::string& name) const { return value(q_, instant, name); }
  Vec velocity(int instant, const std::string& name) const { return value(qd_, instant, name); }
  Vec acceleration(int instant, const std::string& name) const {
    return value(qdd_, instant, name);
  }
  double scalar(int instant, const std::string& name) const { return position(instant, name)[0]; }

 private:
  Vec value(const std::vector<std::vector<double>>& table, int instant,
            const std::string& name) const {
    const Entity& e = m_.entities[m_.find(name)];
    Vec result{};
    for (int i = 0; i < e.size; ++i) {
      if (!e.fixed)
        result[i] = table[instant][e.first + i];
      else if (&table == &q_)
        result[i] = m_.fixed_values[e.first + i];
    }
    return result;
  }

  Model m_;
  std::vector<double> times_;
  std::vector<std::vector<double>> q_, qd_, qdd_;
};

inline void expect_near(const Vec& actual, const Vec& expected, double tolerance,
                        const std::string& what) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], tolerance) << what << ", " << i;
}

/// Expects equal angles modulo 2π.
inline void expect_same_angle(double actual, double expected, double tolerance,
                              const std::string& what) {
  EXPECT_NEAR(std::remainder(actual - expected, 2 * std::numbers::pi), 0, tolerance) << what;
}

/// Returns times from 0 to `end` [s] in steps of 10 ms, small enough to stay on the branch.
inline std::vector<double> instants(double end, double step = 0.01) {
  std::vector<double> times;
  for (int i = 0; i * step <= end; ++i) times.push_back(i * step);
  return times;
}

/// Expects a body to be rigid at an instant: distances, scalar products and handedness equal those
/// of the nominal position. They are recomputed from points and vectors, not from the equations.
inline void expect_rigid(const Mechanism& mechanism, const std::vector<int>& points,
                         const std::vector<int>& vectors, const Solved& solved, int instant,
                         double tolerance) {
  std::vector<std::pair<Vec, Vec>> directions;  // nominal and solved
  std::vector<std::string> names;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = i + 1; j < points.size(); ++j) {
      const auto &p = mechanism.points[points[i]], &q = mechanism.points[points[j]];
      directions.emplace_back(q.position - p.position,
                              solved.position(instant, q.name) - solved.position(instant, p.name));
      names.push_back(p.name + "-" + q.name);
    }
  for (const int v : vectors) {
    directions.emplace_back(mechanism.vectors[v].direction,
                            solved.position(instant, mechanism.vectors[v].name));
    names.push_back(mechanism.vectors[v].name);
  }
  for (std::size_t i = 0; i < directions.size(); ++i)
    for (std::size_t j = i; j < directions.size(); ++j) {
      const auto& [a, a_now] = directions[i];
      const auto& [b, b_now] = directions[j];
      EXPECT_NEAR(dot(a_now, b_now), dot(a, b), tolerance) << names[i] << " · " << names[j];
      if (mechanism.dimension == 2) {
        EXPECT_NEAR(cross(a_now, b_now)[2], cross(a, b)[2], tolerance)
            << names[i] << " × " << names[j];
      }
      for (std::size_t k = j; mechanism.dimension == 3 && k < directions.size(); ++k)
        EXPECT_NEAR(dot(cross(a_now, b_now), directions[k].second),
                    dot(cross(a, b), directions[k].first), tolerance)
            << names[i] << " × " << names[j] << " · " << names[k];
    }
}

/// Expects every body with nominal dimensions to be rigid at every instant.
inline void expect_rigid_bodies(const Mechanism& mechanism, const Solved& solved,
                                double tolerance) {
  for (int k = 0; k < solved.instants() && !testing::Test::HasFailure(); ++k)
    for (const Mechanism::Body& b : mechanism.bodies) {
      if (!b.length) expect_rigid(mechanism, b.points, b.vectors, solved, k, tolerance);
    }
}

/// Expects modelling to throw std::invalid_argument with a message that contains all `parts`.
inline void expect_refused(const Mechanism& mechanism, const std::vector<Motion>& motions,
                           std::initializer_list<std::string_view> parts) {
  const std::string said = refusal([&] { model_mechanism(mechanism, motions); });
  EXPECT_NE(said, "accepted") << mechanism.name;
  for (const std::string_view part : parts)
    EXPECT_NE(said.find(part), std::string::npos) << "'" << part << "' is not in: " << said;
}

}  // namespace desmo
