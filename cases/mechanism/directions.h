// Nominal points of bodies, and unit vectors along lines and normals.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Returns the points of a body: in the body's own frame, if it has one; otherwise as drawn.
std::vector<Mechanism::Vec> shape_of(const Mechanism& mechanism, const Mechanism::Body& body);

/// Returns x scaled to length 1; nothing when all components are zero.
std::optional<Mechanism::Vec> unit_vector(const Mechanism::Vec& x);

/// Returns the unit vector from p to q. Returns nothing when they coincide: no component differs by
/// more than 1e-12 of the largest absolute component of p and q.
std::optional<Mechanism::Vec> direction(const Mechanism::Vec& p, const Mechanism::Vec& q);

/// Returns a vector times a power of two. Its largest component then has a magnitude from 1 up to
/// 2, so that products of such vectors neither overflow nor vanish. The vector 0 stays as it is.
Mechanism::ExactVec near_unit(const Mechanism::ExactVec& x);

/// Returns the remainders of a unit vector: what each of its rounded components lacks.
/// - along: exact vector of the same direction, of any length but 0
std::array<Remainder, 3> remainder_of(const Mechanism::Vec& unit, const Mechanism::ExactVec& along);

/// Returns the unit vector along a × b of unit vectors a, b. Returns nothing when they are nearly
/// parallel: |component| < 1e-8 for each component of a × b, which then lacks half of its digits.
std::optional<Mechanism::Vec> common_normal(const Mechanism::Vec& a, const Mechanism::Vec& b);

}  // namespace desmo
