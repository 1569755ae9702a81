#pragma once

#include "cases/mechanism/mechanism.h"

/// What a description is in its nominal position.
namespace desmo::nominal {

using Vec = Mechanism::Vec;

Vec operator-(const Vec& a, const Vec& b);
double dot(const Vec& a, const Vec& b);
double norm(const Vec& a);
/// A direction; a segment with its length.
Vec direction(const Mechanism& mechanism, const Mechanism::Direction& d);
/// The value of a relative coordinate, rad or length.
double value(const Mechanism& mechanism, const Mechanism::Coordinate& coordinate);
/// The largest distance between a point and the first, but 1 for a mechanism that has no extent.
double size(const Mechanism& mechanism);

}  // namespace desmo::nominal
