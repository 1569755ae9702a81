// The parts of validate(const Description&). Each throws DescriptionError and relies on those
// before it.
#pragma once

#include <string>

#include "cases/mechanism/carriers.h"
#include "cases/mechanism/error.h"

namespace desmo {

/// Throws "joint 'J1': <what>" for an entry of the description.
[[noreturn]] void refuse(const Description& description, DescriptionError::Part part, int index,
                         const std::string& what);

/// Whether a position is one of a list.
template <class List>
bool is_in(int index, const List& list) {
  return index >= 0 && index < static_cast<int>(list.size());
}

void check_names(const Description& description);

/// Numbers, indices and what they imply, of points, vectors and bodies.
void check_entities(const Description& description);

/// That vectors along a segment have two points of a body that carries them.
void check_vectors_along(const Description& description, const Carriers& points,
                         const Carriers& vectors);

/// That joints have what their type asks for, of the bodies that carry it.
void check_joints(const Description& description, const Carriers& points, const Carriers& vectors);

/// That joints say of everything carried by several bodies that these share it.
void check_sharing(const Description& description, const Carriers& points, const Carriers& vectors);

void check_coordinates(const Description& description, const Carriers& points,
                       const Carriers& vectors);

}  // namespace desmo
