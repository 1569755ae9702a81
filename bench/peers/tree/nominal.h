#pragma once

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

// Dimensions of a mechanism. All functions throw std::invalid_argument when there is no such name;
// length() throws std::bad_optional_access for a body without a length of its own.

/// Returns the point, vector, body … of that name.
template <class Named>
const Named& named(const std::vector<Named>& all, const std::string& name) {
  const auto it = std::ranges::find(all, name, &Named::name);
  if (it == all.end()) throw std::invalid_argument("there is no '" + name + "'");
  return *it;
}

inline Vec nominal(const Mechanism& d, const std::string& point) {
  return Vec(named(d.points, point).position.data());
}

/// Returns the length that a link has by definition; its nominal position is but an estimate.
inline double length(const Mechanism& d, const std::string& link) {
  return named(d.bodies, link).length.value().value;
}

}  // namespace desmo::tree
