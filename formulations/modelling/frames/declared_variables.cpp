#include "formulations/modelling/frames/declared_variables.h"

namespace desmo {

/// Returns whether a coordinate is found by the group of a body, so that it can be its variable.
bool DeclaredVariables::is_found_with(int body, const Mechanism::Coordinate& c) const {
  return placement_.of(c) == structure_.of_body[body];
}

int DeclaredVariables::travel(int body, const Mechanism::Joint& j) const {
  const std::vector<Mechanism::Coordinate>& all = framed_.mechanism.coordinates;
  for (int c = 0; c < static_cast<int>(all.size()); ++c)
    if (is_distance_of(j, all[c]) && is_found_with(body, all[c])) return c;
  return Mechanism::none;
}

int DeclaredVariables::angle(int body, int axis) const {
  const int parent = framed_.tree.hanging[body].parent;
  const std::vector<Mechanism::Coordinate>& all = framed_.mechanism.coordinates;
  for (int c = 0; c < static_cast<int>(all.size()); ++c)
    if (all[c].type == Mechanism::CoordinateType::angle && is_found_with(body, all[c]) &&
        carries(framed_.rigid, body, all[c].of) && turns(all[c], parent, body, axis))
      return c;
  return Mechanism::none;
}

/// Returns whether an angle of a body is the turn of its tree joint: it is measured from directions
/// of the parent and, in space, all its directions are normal to the axis.
bool DeclaredVariables::turns(const Mechanism::Coordinate& a, int parent, int body,
                              int axis) const {
  if (!a.from.is_given()) return parent == 0;
  if (!carries(framed_.rigid, parent, a.from)) return false;
  if (framed_.mechanism.dimension == 2) return true;
  if (!carries(framed_.rigid, parent, a.towards) || a.from.is_line() || a.towards.is_line())
    return false;
  const AxisMaker::Exact u = axes_.own(parent, axis), f = axes_.own(parent, a.from),
                         g = axes_.own(parent, a.towards);
  return are_normal(u, f) && are_normal(u, g) && are_normal(f, g) &&
         are_normal(axes_.own(body, axis), unit(axes_.own(body, a.of)));
}

}  // namespace desmo
