#include "formulations/modelling/measures/frames.h"

#include <cmath>

#include "formulations/constraints/vec.h"

namespace desmo::frames {

namespace {

Vector cross(const Vector& a, const Vector& b) {
  Vector c;
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    c[i] = a[j] * b[k] - a[k] * b[j];
  }
  return c;
}

}  // namespace

Number dot(const Vector& a, const Vector& b) { return vec::dot<3>(a.data(), b.data()); }

Vector unit(const Vector& a) {
  const Number scale = 1 / std::sqrt(dot(a, a).value);
  return {scale * a[0], scale * a[1], scale * a[2]};
}

Frame frame_of(const Vector& u, const Vector& v) {
  const Vector x = unit(u), z = unit(cross(u, v));
  return {x, cross(z, x), z};
}

Frame frame_of(const Vector& u) { return frame_of(u, {-u[1], u[0], 0.}); }

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
  return is_line ? vec::difference<3>(from(instant).data(), to(instant).data()) : to(instant);
}

Frame BodyFrame::operator()(const Instant& instant) const {
  if (lines.empty()) return ground;
  const Vector u = lines[0](instant);
  return lines.size() > 1 ? frame_of(u, lines[1](instant)) : frame_of(u);
}

}  // namespace desmo::frames
