#pragma once

#include "cases/mechanism/mechanism.h"

/// Geometry of a mechanism in its nominal position.
namespace desmo::nominal {

using Vec = Mechanism::Vec;

Vec operator-(const Vec& a, const Vec& b);
double dot(const Vec& a, const Vec& b);
double norm(const Vec& a);
/// Returns a direction: a vector as declared, or a line with its length.
Vec direction(const Mechanism& mechanism, const Mechanism::Direction& d);
/// Returns the value of a relative coordinate: an angle [rad] or a length.
double value(const Mechanism& mechanism, const Mechanism::Coordinate& coordinate);
/// Returns the largest distance of a point from the first one; 1 for a mechanism without extent.
double size(const Mechanism& mechanism);

}  // namespace desmo::nominal
