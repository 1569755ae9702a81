// The parts of validate(const Description&). Each throws DescriptionError and relies on those
// before it.
#pragma once

#include <string>

#include "cases/mechanism/carriers.h"
#include "cases/mechanism/error.h"

namespace desmo {

/// Throws "joint 'J1': <what>" for an entry of the description.
[[noreturn]] void refuse(const Mechanism& mechanism, MechanismError::Part part, int index,
                         const std::string& what);

/// Whether a position is one of a list.
template <class List>
bool is_in(int index, const List& list) {
  return index >= 0 && index < static_cast<int>(list.size());
}

void check_names(const Mechanism& mechanism);

/// Numbers, indices and what they imply, of points, vectors and bodies.
void check_entities(const Mechanism& mechanism);

/// That vectors along a segment have two points of a body that carries them.
void check_vectors_along(const Mechanism& mechanism, const Carriers& points,
                         const Carriers& vectors);

/// That joints have what their type asks for, of the bodies that carry it.
void check_joints(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors);

/// That joints say of everything carried by several bodies that these share it.
void check_sharing(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors);

void check_coordinates(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors);

}  // namespace desmo
