#include "formulations/modelling/measures/body_frames.h"

#include <Eigen/Geometry>
#include <cmath>
#include <stdexcept>
#include <string>

#include "cases/numbers/space.h"
#include "formulations/constraints/vec.h"
#include "formulations/modelling/bodies/drawing.h"

namespace desmo::frames {

namespace {

/// Returns a frame from directions of a body: their lengths and the angle between them are
/// constant.
Frame frame_of(const Vector& u, const Vector& v) {
  const Vector x = unit(u), z = unit(cross(u, v));
  return {x, cross(z, x), z};
}

/// Returns a frame in the plane from a direction of a body.
Frame frame_of(const Vector& u) { return frame_of(u, {-u[1], u[0], 0.}); }

}  // namespace

Vector unit(const Vector& a) {
  const Number scale = 1 / std::sqrt(dot(a, a).value);
  return {scale * a[0], scale * a[1], scale * a[2]};
}

Frame seen_from(const Frame& other, const Frame& frame) {
  Frame seen;
  for (int k = 0; k < 3; ++k)
    for (int i = 0; i < 3; ++i) seen[k][i] = dot(other[i], frame[k]);
  return seen;
}

Vector Operand::operator()(const Instant& instant) const {
  Vector x = fixed;
  const bool has_rate = level >= Level::velocity && !instant.qd.empty();
  const bool has_second = level >= Level::acceleration && !instant.qdd.empty();
  for (int i = 0; i < size; ++i)
    x[i] = {instant.q[first + i], has_rate ? instant.qd[first + i] : 0,
            has_second ? instant.qdd[first + i] : 0};
  return x;
}

Vector Line::operator()(const Instant& instant) const {
  return vec::difference<3>(from(instant).data(), to(instant).data());
}

Frame BodyFrame::operator()(const Instant& instant) const {
  if (lines.empty()) return ground;
  const Vector u = lines[0](instant);
  return lines.size() > 1 ? frame_of(u, lines[1](instant)) : frame_of(u);
}

Line BodyFrames::find_line(const Mechanism::Direction& d) {
  if (!d.is_line()) return {find_operand(mechanism_.vectors[d.vector].name), {}};
  return {find_operand(mechanism_.points[d.to].name), find_operand(mechanism_.points[d.from].name)};
}

bool BodyFrames::tells_turn(int body) const {
  const int r = rigid_.of_body[body];
  return r == 0 || rigid_.list[r].basis.directions.size() >= directions_needed();
}

BodyFrame BodyFrames::find_frame(int body) {
  BodyFrame result;
  const int r = rigid_.of_body[body];
  if (r == 0) return result;
  const auto& directions = rigid_.list[r].basis.directions;
  if (!tells_turn(body))
    throw std::invalid_argument("request: the points and vectors of body '" +
                                mechanism_.bodies[body].name +
                                "' do not tell how it is turned; give it another" +
                                (directions_needed() == 2 ? " that is not in line with them" : "") +
                                ", or ask for an angle or a vector");
  for (std::size_t k = 0; k < directions_needed(); ++k)
    result.lines.push_back(find_line(directions[k]));
  const Vector u = drawn(body, directions[0]);
  result.drawn = directions_needed() == 2 ? frame_of(u, drawn(body, directions[1])) : frame_of(u);
  return result;
}

Vector BodyFrames::drawn(int body, const Mechanism::Direction& direction) const {
  const BodyDrawing<double> drawing{mechanism_};
  auto x = drawing.direction(direction);
  if (mechanism_.bodies[body].own) {
    const auto local = drawing.direction(rigid_.list[rigid_.of_body[body]], direction);
    Eigen::Vector3d::Map(x.data()) = turn_of_frame(body) * Eigen::Vector3d(local.data());
  }
  return {x[0], x[1], x[2]};
}

Eigen::Matrix3d BodyFrames::turn_of_frame(int body) const {
  const auto& own = mechanism_.bodies[body].own;
  if (!own) return Eigen::Matrix3d::Identity();
  const Eigen::Vector3d rotation(own->rotation.data());
  return Eigen::AngleAxisd(rotation.norm(), rotation.normalized()).toRotationMatrix();
}

Operand BodyFrames::find_operand(const std::string& name) {
  const EntityId id = m_.find(name);
  inputs_.push_back({id, level});
  const Entity& e = m_.entities[id];
  Operand result{.first = e.first, .size = e.fixed ? 0 : e.size, .level = level};
  for (int i = 0; e.fixed && i < e.size; ++i) result.fixed[i] = m_.fixed_values[e.first + i];
  return result;
}

}  // namespace desmo::frames
