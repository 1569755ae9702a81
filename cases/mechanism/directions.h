// Nominal directions of vectors and of lines, and the points that they join.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Returns the points of a body: in the body's frame, if it has one, or as drawn.
std::vector<Mechanism::Vec> shape_of(const Mechanism& mechanism, const Mechanism::Body& body);

/// Returns x scaled to length 1; nothing when all components are zero.
std::optional<Mechanism::Vec> unit_vector(const Mechanism::Vec& x);

/// Returns the unit vector from p to q; nothing when they coincide within rounding.
std::optional<Mechanism::Vec> direction(const Mechanism::Vec& p, const Mechanism::Vec& q);

/// Returns what the components of a unit vector lack. along: a vector that it has the direction of,
/// not zero.
std::array<Remainder, 3> remainder_of(const Mechanism::Vec& unit,
                                      const std::array<Derived, 3>& along);

/// Returns the unit vector along a × b of unit vectors a, b. Returns nothing when these are
/// parallel, or so nearly that the product has lost half of its digits.
std::optional<Mechanism::Vec> common_normal(const Mechanism::Vec& a, const Mechanism::Vec& b);

}  // namespace desmo
