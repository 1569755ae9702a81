#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "formulations/modelling/modelling.h"
#include "tests/describing.h"

namespace desmo {

inline Model model(const Mechanism& d) {
  const auto drivers = std::ranges::count(d.coordinates, true, &Mechanism::Coordinate::driven);
  return model_mechanism(d, std::vector<Motion>(drivers, still)).model;
}

/// A link by its name and those of its pins.
using PinnedLink = std::pair<std::string, std::vector<std::string>>;
/// The line of two pins.
using PinLine = std::pair<std::string, std::string>;

/// Returns a planar linkage of pinned links, the angles of these lines driven.
inline Mechanism linkage(const std::string& name, const std::map<std::string, Vec>& pins,
                         const PinnedLink& ground, const std::vector<PinnedLink>& links,
                         const std::vector<PinLine>& driven) {
  Sketch d(name, 2);
  std::map<std::string, int> points;
  for (const auto& [pin, at] : pins) points[pin] = d.point(pin, at);
  const auto points_of = [&](const PinnedLink& link) {
    std::vector<int> result;
    for (const std::string& pin : link.second) result.push_back(points.at(pin));
    return result;
  };
  d.carry(Sketch::ground, points_of(ground));
  for (const PinnedLink& link : links) d.body(link.first, points_of(link));
  for (const auto& [a, b] : driven)
    d.angle("angle of " + a + b, line(points.at(a), points.at(b))).driven = true;
  return d.release_pinned();
}

}  // namespace desmo
