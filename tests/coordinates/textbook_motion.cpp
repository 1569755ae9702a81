#include "tests/coordinates/textbook_motion.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <string>

#include "cases/mechanism/joint_forms.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"

namespace desmo::textbook_test {

Instant::Instant(const Scene& scene, Modelling kind, double time)
    : m(make_model(scene, kind)),
      rigid_(find_rigid_bodies(scene.mechanism)),
      framed(put_frames(scene.mechanism, rigid_, find_structure(scene.mechanism, rigid_), kind)),
      part_(make_partition(m, Partition::global).front()) {
  for (const PartDefinition& part : make_partition(m, Partition::global))
    if (!part.constant && part.unknowns.size() > derivations(m, part).size()) part_ = part;
  Settings settings;
  settings.fixed_iterations = 6;  // to what rounding leaves
  settings.coordinates = kind;
  const auto f = make_formulation(find_variant("group_automatic_lapack"), m, settings);
  EXPECT_TRUE(f->assemble(0).ok() && f->step(time).ok()) << m.name;
  q = {f->q().begin(), f->q().end()};
  qd = {f->qd().begin(), f->qd().end()};
  q.insert(q.end(), m.fixed_values.begin(), m.fixed_values.end());
  qd.resize(q.size());
  condense();
  move_bodies();
}

Vector3d Instant::at(const std::vector<double>& state, EntityId e) const {
  Vector3d x = Vector3d::Zero();
  for (int i = 0; i < m.entities[e].size; ++i) x[i] = state[m.state_index(e) + i];
  return x;
}

std::pair<int, bool> Instant::carrier(EntityId e) const {
  const auto find = [&](const auto& list, const std::vector<int>& deriving) {
    for (std::size_t i = 0; i < list.size(); ++i)
      if (list[i].name == m.entities[e].name)
        return deriving[i] > 0 && framed.tree.has_frame[deriving[i]] ? deriving[i] : -1;
    return -1;
  };
  const bool is_point = m.entities[e].kind == EntityKind::point;
  if (m.entities[e].fixed) return {-1, is_point};
  return {is_point ? find(framed.mechanism.points, framed.deriving)
                   : find(framed.mechanism.vectors, framed.deriving_vector),
          is_point};
}

int Instant::body_of(std::string_view constraint) const {
  const Mechanism& mechanism = framed.mechanism;
  for (std::size_t r = 1; r < framed.rigid.list.size(); ++r)
    if (constraint.starts_with(mechanism.bodies[framed.rigid.list[r].bodies.front()].name + ": "))
      return static_cast<int>(r);
  return -1;
}

Instant::Rates Instant::rates(EntityId e) const {
  const auto [body, is_point] = carrier(e);
  if (body >= 0) return rates(e, body, is_point);
  Rates own{at(q, e), at(qd, e), Vector3d::Zero(), {}};  // an unknown, or fixed
  for (int i = 0; i < m.entities[e].size; ++i)
    if (const auto c = column.find(m.state_index(e) + i); c != column.end())
      own.by[c->second] = Vector3d::Unit(i);
  return own;
}

Instant::Rates Instant::rates(EntityId e, int body, bool is_point) const {
  const Body& b = bodies_[body];
  const Vector3d x = at(q, e), s = is_point ? Vector3d(x - b.origin) : x;
  Rates r{x, at(qd, e), b.alpha.cross(s) + b.omega.cross(b.omega.cross(s)), {}};
  if (is_point) r.bias += b.origin_bias;
  for (const Screw& screw : b.screws) {
    const Vector3d arm = is_point ? Vector3d(x - screw.through) : x;
    Vector3d moved = screw.turn.cross(arm);
    if (is_point) moved += screw.slide;
    auto [at, is_new] = r.by.emplace(screw.column, moved);
    if (!is_new) at->second += moved;
  }
  return r;
}

void Instant::move_bodies() {
  bodies_.resize(framed.rigid.list.size());
  for (const int r : framed.tree.order)
    if (framed.tree.has_frame[r]) move_body(r);
}

void Instant::move_body(int r) {
  const Mechanism& mechanism = framed.mechanism;
  const DerivedFrame& frame = framed.frames[r];
  const TreeJoint& hanging = framed.tree.hanging[r];
  const Mechanism::Joint* const joint =
      hanging.joint < 0 ? nullptr : &mechanism.joints[hanging.joint];
  const Body& parent = bodies_[hanging.parent];
  const std::string own =
      joint ? joint->name : mechanism.bodies[framed.rigid.list[r].bodies.front()].name;
  Body b = parent;
  b.origin = at(q, point(frame.origin));
  const auto turn = [&](EntityId angle, const Vector3d& axis) {
    const int state = m.state_index(angle);
    if (const auto c = column.find(state); c != column.end())
      b.screws.push_back({c->second, axis, b.origin, Vector3d::Zero()});
    b.alpha += b.omega.cross(axis) * qd[state];
    b.omega += axis * qd[state];
  };
  const auto angle = [&] {
    return m.find(frame.angle >= 0 ? mechanism.coordinates[frame.angle].name : own + "/angle");
  };
  const auto orient = [&](const Eigen::Matrix3d& axes) {
    const Entity& e = m.entities[m.find(mechanism.bodies[framed.rigid.list[r].bodies.front()].name +
                                        "/orientation")];
    for (int k = 0; k < 3; ++k)
      b.screws.push_back({column.at(e.first) + 1 + k, axes.col(k), b.origin, Vector3d::Zero()});
    const Vector3d x(q[e.first + 1], q[e.first + 2], q[e.first + 3]),
        v(qd[e.first + 1], qd[e.first + 2], qd[e.first + 3]);
    const Vector3d omega = axes * (2 * (q[e.first] * v - qd[e.first] * x + x.cross(v)));
    b.alpha += b.omega.cross(omega);
    b.omega += omega;
  };
  const bool is_plane = mechanism.dimension == 2;
  const auto type = joint ? joint->type : Mechanism::JointType::spherical;
  if (!joint) {
    b = Body();
    b.origin = at(q, point(frame.origin));
    for (int i = 0; i < mechanism.dimension; ++i)
      b.screws.push_back({column.at(m.state_index(point(frame.origin)) + i), Vector3d::Zero(),
                          Vector3d::Zero(), Vector3d::Unit(i)});
    is_plane ? turn(angle(), Vector3d::UnitZ()) : orient(Eigen::Matrix3d::Identity());
  } else if (type != Mechanism::JointType::prismatic) {
    if (is_plane) {
      turn(angle(), Vector3d::UnitZ());
    } else if (type == Mechanism::JointType::spherical) {
      Eigen::Matrix3d axes;
      for (int k = 0; k < 3; ++k)
        axes.col(k) = at(q, vector(framed.frames[hanging.parent].axes[k]));
      orient(axes);
    } else {
      const Vector3d f = at(q, vector(frame.from)), g = at(q, vector(frame.towards));
      turn(angle(), frame.opposite ? Vector3d(g.cross(f)) : Vector3d(f.cross(g)));
      if (type == Mechanism::JointType::universal)
        turn(m.find(own + "/second angle"), at(q, vector(frame.axes[2])));
    }
  }
  bodies_[r] = b;
  if (!joint || !slides(joint->type)) {
    if (joint) bodies_[r].origin_bias = rates(point(frame.origin)).bias;
    return;
  }
  // Q = P + s u
  const EntityId s =
      m.find(frame.travel >= 0 ? mechanism.coordinates[frame.travel].name : own + "/travel");
  int from = joint->points[0];
  if (frame.travel >= 0) from = mechanism.coordinates[frame.travel].of.from;
  const int mine = joint->points[hanging.is_first ? 0 : 1];
  const double sign = from == mine ? -1 : 1;
  const EntityId u = vector(joint->vectors[0]);
  const Rates axis = rates(u),
              other = rates(point(mine == joint->points[0] ? joint->points[1] : joint->points[0]));
  const double travel = q[m.state_index(s)], rate = qd[m.state_index(s)];
  bodies_[r].origin_bias = other.bias + sign * (2 * rate * axis.velocity + travel * axis.bias);
  // The origin slides along u and is carried by what turns u.
  std::vector<Screw>& screws = bodies_[r].screws;
  const Vector3d& P = other.value;
  for (std::size_t k = parent.screws.size(); k < screws.size(); ++k)
    if (carrier(u).first == r) screws[k].through = P;  // the line is the body's own
  if (const auto c = column.find(m.state_index(s)); c != column.end())
    screws.push_back({c->second, Vector3d::Zero(), Vector3d::Zero(), sign * axis.value});
}

}  // namespace desmo::textbook_test
