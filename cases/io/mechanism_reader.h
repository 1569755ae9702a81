// The parts of a mechanism file, in the order in which they are read. All complain with InputError.
#pragma once

#include "cases/io/format.h"
#include "cases/io/name_table.h"
#include "cases/mechanism/mechanism.h"

namespace desmo {

/// Names that are known; texts of the document.
struct Names {
  NameTable points{"point"}, vectors{"vector"}, bodies{"body"}, coordinates{"coordinate"};
};

/// A mechanism, validated, and the units of its file.
struct ReadMechanism {
  Mechanism mechanism;
  Units units;
};
ReadMechanism mechanism_from(const JsonValue& root);

/// Has as many components as the mechanism has dimensions; the third is 0 in the plane.
Mechanism::Vec read_components(const JsonValue& value, int dimension);

/// A vector's name, or a list of two points.
Mechanism::Direction read_direction(const JsonValue& value, const Names& names);

std::vector<Mechanism::Vector> read_vectors(const JsonValue& root, int dimension,
                                            const std::vector<Mechanism::Point>& points,
                                            Names& names);

/// `bodies` are for the names of joints that have none.
std::vector<Mechanism::Joint> read_joints(const JsonValue& root,
                                          const std::vector<Mechanism::Body>& bodies,
                                          const Names& names);

/// With their drivers.
std::vector<Mechanism::Coordinate> read_coordinates(const JsonValue& root, int dimension,
                                                    const Units& units, Names& names);

}  // namespace desmo
