#include "formulations/modelling/coordinates/nominal.h"

#include <algorithm>
#include <cmath>

namespace desmo::nominal {

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double norm(const Vec& a) { return std::sqrt(dot(a, a)); }

Vec direction(const Mechanism& d, const Mechanism::Direction& direction) {
  return direction.is_line() ? d.points[direction.to].position - d.points[direction.from].position
                             : d.vectors[direction.vector].direction;
}

double value(const Mechanism& d, const Mechanism::Coordinate& c) {
  using enum Mechanism::CoordinateType;
  if (c.type == component) return d.points[c.point].position[c.axis];
  const Vec w = direction(d, c.of);
  if (c.type == distance) return norm(w);
  if (c.type == along) return dot(w, d.vectors[c.vector].direction);
  if (d.dimension == 3) {
    const double cosine = dot(w, direction(d, c.from));
    return std::atan2(dot(w, direction(d, c.towards)), c.opposite ? -cosine : cosine);
  }
  const Vec x = c.from.is_given() ? direction(d, c.from) : Vec{1, 0, 0};
  return std::atan2(x[0] * w[1] - x[1] * w[0], dot(x, w));
}

double size(const Mechanism& d) {
  double largest = 0;
  for (const Mechanism::Point& p : d.points)
    largest = std::max(largest, norm(p.position - d.points.front().position));
  return largest > 0 ? largest : 1;
}

}  // namespace desmo::nominal
