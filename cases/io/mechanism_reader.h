// Readers of the sections of a mechanism file, in reading order. All throw InputError.
#pragma once

#include "cases/io/format.h"
#include "cases/io/name_table.h"
#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Known names; references to texts of the document.
struct Names {
  NameTable points{"point"}, vectors{"vector"}, bodies{"body"}, coordinates{"coordinate"};
};

/// A validated mechanism and the units of its file.
struct ReadMechanism {
  Mechanism mechanism;
  Units units;
};
ReadMechanism mechanism_from(const JsonValue& root);

/// Reads as many components as the mechanism has dimensions; in the plane the third becomes 0.
Mechanism::Vec read_components(const JsonValue& value, int dimension);

/// Reads a vector's name, or a list of two points.
Mechanism::Direction read_direction(const JsonValue& value, const Names& names);

std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names);

/// Reads joints. bodies: supply the names of joints without one.
std::vector<Mechanism::Joint> read_joints(const JsonValue& root,
                                          const std::vector<Mechanism::Body>& bodies,
                                          const Names& names);

/// Reads relative coordinates and which of them are driven.
std::vector<Mechanism::Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                                    const Units& units, Names& names);

}  // namespace desmo
