#include "bench/peers/simbody_tree.h"

namespace desmo::simbody {

namespace {

namespace sim = SimTK;

sim::Vec3 vec3(const Vec& v) { return {v[0], v[1], v[2]}; }

/// Returns a rotation that turns a joint's own axis, as Simbody defines it, to a given axis.
sim::Rotation turning(const sim::CoordinateAxis& own, const Vec& axis) {
  return sim::Rotation(sim::UnitVec3(vec3(axis)), own);
}

/// A prescribed motion of a coordinate.
class Prescribed final : public sim::Motion::Custom::Implementation {
 public:
  explicit Prescribed(std::function<Vec(double)> motion) : motion_(std::move(motion)) {}

 private:
  Implementation* clone() const override { return new Prescribed(motion_); }
  sim::Motion::Level getLevel(const sim::State&) const override { return sim::Motion::Position; }
  void calcPrescribedPosition(const sim::State& s, int, double* q) const override {
    *q = motion_(s.getTime())[0];
  }
  void calcPrescribedPositionDot(const sim::State& s, int, double* qd) const override {
    *qd = motion_(s.getTime())[1];
  }
  void calcPrescribedPositionDotDot(const sim::State& s, int, double* qdd) const override {
    *qdd = motion_(s.getTime())[2];
  }

  std::function<Vec(double)> motion_;
};

sim::MobilizedBody add(sim::MobilizedBody& parent, const Body& b) {
  // Kinematics does not ask for masses, but realising accelerations does.
  const sim::Body::Rigid rigid(sim::MassProperties(1, sim::Vec3(0), sim::Inertia(1)));
  const auto outer = [&](const sim::Rotation& r) { return sim::Transform(r, vec3(b.place)); };
  const auto inner = [](const sim::Rotation& r) { return sim::Transform(r, sim::Vec3(0)); };
  switch (b.joint) {
    case Joint::pin: {
      const sim::Rotation r = turning(sim::ZAxis, b.axis);
      return sim::MobilizedBody::Pin(parent, outer(r), rigid, inner(r));
    }
    case Joint::slider: {
      const sim::Rotation r = turning(sim::XAxis, b.axis);
      return sim::MobilizedBody::Slider(parent, outer(r), rigid, inner(r));
    }
    case Joint::gimbal: {
      const sim::Rotation r;
      return sim::MobilizedBody::Gimbal(parent, outer(r), rigid, inner(r));
    }
    case Joint::universal: {
      const sim::Rotation r(sim::UnitVec3(vec3(b.axis)), sim::XAxis, vec3(b.second_axis),
                            sim::YAxis);
      return sim::MobilizedBody::Universal(parent, outer(r), rigid, inner(r));
    }
  }
  throw std::logic_error("simbody: unknown joint");
}

void add(sim::MobilizedBody& first, sim::MobilizedBody& second, const Constraint& c) {
  const sim::Vec3 a = vec3(c.points[0]), b = vec3(c.points[1]);
  switch (c.kind) {
    case Constraint::Kind::rod:
      sim::Constraint::Rod(first, a, second, b, c.length);
      return;
    case Constraint::Kind::point_on_line:
      sim::Constraint::PointOnLine(first, sim::UnitVec3(vec3(c.direction)), a, second, b);
      return;
    case Constraint::Kind::point_in_plane: {
      const sim::UnitVec3 normal(vec3(c.direction));
      sim::Constraint::PointInPlane(first, normal, sim::dot(normal, a), second, b);
    }
  }
}

}  // namespace

BuiltTree::BuiltTree(const Tree& tree) {
  for (const Body& b : tree.bodies) {
    bodies.push_back(add(body(b.parent), b));
    if (b.driver >= 0)
      sim::Motion::Custom(bodies.back(), new Prescribed(tree.drivers.at(b.driver)));
  }
  for (const Constraint& c : tree.constraints) add(body(c.bodies[0]), body(c.bodies[1]), c);
}

}  // namespace desmo::simbody
