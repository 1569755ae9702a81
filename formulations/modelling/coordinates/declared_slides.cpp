#include "formulations/modelling/coordinates/declared_slides.h"

#include <algorithm>

namespace desmo {

DeclaredSlides::DeclaredSlides(const Mechanism& d) {
  for (const Mechanism::Coordinate& c : d.coordinates)
    if (c.type == Mechanism::CoordinateType::along)
      declared_.insert({c.vector, std::min(c.of.from, c.of.to), std::max(c.of.from, c.of.to)});
}

bool DeclaredSlides::slides(const Mechanism::Joint& j) {
  return j.points.size() == 2;  // a point of each body (see JointForm)
}

bool DeclaredSlides::contain(const Mechanism::Joint& j) const {
  if (!slides(j)) return false;
  const auto [low, high] = std::minmax(j.points[0], j.points[1]);
  return declared_.contains({j.vectors[0], low, high});
}

}  // namespace desmo
