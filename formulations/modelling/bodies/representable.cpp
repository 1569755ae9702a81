#include "formulations/modelling/bodies/representable.h"

#include <cmath>
#include <cstdio>
#include <stdexcept>
#include <string>

namespace desmo {

namespace {

/// Their squares, and the rounding of these, are normal numbers.
constexpr double shortest = 1e-152, longest = 1e152;

void require(double length, const std::string& body) {
  if (length == 0 || !std::isfinite(length) || (length >= shortest && length <= longest)) return;
  char text[120];
  std::snprintf(
      text, sizeof text,
      "': the square of a length of %.0e on it is beyond double precision; choose another "
      "unit of length",
      length);
  throw std::invalid_argument("body '" + body + text);
}

}  // namespace

void require_representable(const Mechanism& d) {
  for (const Mechanism::Body& body : d.bodies) {
    if (&body == &d.bodies.front()) continue;  // its points are where they are
    if (body.length) require(*body.length, body.name);
    for (const int p : body.points) {
      const Mechanism::Vec &a = d.points[body.points.front()].position, &b = d.points[p].position;
      require(std::hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]), body.name);
    }
  }
}

}  // namespace desmo
