// Nominal directions, of vectors and of segments.
#pragma once

#include <optional>

#include "cases/mechanism/description.h"

namespace desmo {

/// x scaled to length 1; nothing when its components are all zero.
std::optional<Description::Vec> unit_vector(const Description::Vec& x);

/// The unit vector from p to q; nothing when they coincide but for rounding.
std::optional<Description::Vec> direction(const Description::Vec& p, const Description::Vec& q);

/// The unit vector along a × b, of unit vectors; nothing when these are parallel, or so nearly
/// that the product has lost half of its digits.
std::optional<Description::Vec> common_normal(const Description::Vec& a, const Description::Vec& b);

}  // namespace desmo
