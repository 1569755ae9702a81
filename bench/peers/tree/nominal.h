#pragma once

#include <string>

#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"
#include "cases/mechanism/names.h"

namespace desmo::tree {

// Dimensions of a mechanism. Both functions throw std::invalid_argument when there is no such name.

/// Returns the nominal position of a point.
inline Vec nominal(const Mechanism& mechanism, const std::string& point) {
  return Vec(entry_named(point, mechanism.points, "point").position.data());
}

/// Returns the length that a link has by definition; its nominal position is but an estimate.
/// Throws std::bad_optional_access for a body without such a length.
inline double length(const Mechanism& mechanism, const std::string& link) {
  return entry_named(link, mechanism.bodies, "body").length.value().value;
}

}  // namespace desmo::tree
