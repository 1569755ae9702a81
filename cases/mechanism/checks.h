// The steps of validate(const Mechanism&), the error that each throws, and functions that modelling
// uses as well. Each step relies on the previous ones.
#pragma once

#include <stdexcept>
#include <string>

#include "cases/mechanism/carriers.h"
#include "cases/mechanism/disjoint_sets.h"

namespace desmo {

/// Error that validate(const Mechanism&) throws. It names the wrong entry, so that a parser can
/// point at its position in the file.
class MechanismError : public std::invalid_argument {
 public:
  enum class Part { mechanism, point, vector, body, joint, coordinate, coupling };

  MechanismError(Part part, int index, const std::string& message)
      : std::invalid_argument(message), part_(part), index_(index) {}

  Part part() const { return part_; }
  int index() const { return index_; }  ///< index in the list of the part; Part::mechanism: 0

 private:
  Part part_;
  int index_;
};

/// Function that throws MechanismError "joint 'J1': <what>" for an entry of a mechanism.
struct EntryRefusal {
  const Mechanism& mechanism;
  MechanismError::Part part;
  int index;

  [[noreturn]] void operator()(const std::string& what) const;
};

/// Returns the sets of bodies that move as one, because fixed joints connect them.
/// DisjointSets::find() of a body returns the least index in its set.
DisjointSets fixed_bodies(const Mechanism& mechanism);

/// Returns the direction of a vector that a body carries: in the body's own frame, if it has one;
/// otherwise as drawn.
Mechanism::Vec carried_vector(const Mechanism& mechanism, int body, int vector);

/// Returns whether an index is within a list.
template <class List>
bool is_in(int index, const List& list) {
  return index >= 0 && index < static_cast<int>(list.size());
}

/// Checks that no name is empty. Names are unique among bodies, among joints and among couplings.
/// Points, vectors and coordinates share one set of names.
void check_names(const Mechanism& mechanism);

/// Checks numbers and indices of points, vectors and bodies, and lengths and frames of bodies. The
/// points of a moving body without vectors must not all coincide, if it has two or more.
void check_entities(const Mechanism& mechanism);

/// Checks that the two points of each `along` vector do not coincide. If bodies carry the vector,
/// one of them must carry both points.
void check_vectors_along(const Mechanism& mechanism, const Carriers& points,
                         const Carriers& vectors);

/// Checks that joints have the entities that their type requires, carried by their bodies.
void check_joints(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors);

/// Checks that coordinates have the members that their type requires, and that bodies carry what
/// they measure.
void check_coordinates(const Mechanism& mechanism, const Carriers& points, const Carriers& vectors);

/// Checks that couplings relate two to four different coordinates, of which at least one is not
/// driven. Factors must be finite and not 0, and make_spline() must take the tables.
void check_couplings(const Mechanism& mechanism);

}  // namespace desmo
