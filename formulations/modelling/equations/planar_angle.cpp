#include <algorithm>
#include <optional>
#include <stdexcept>

#include "formulations/modelling/coordinates/definition.h"

namespace desmo {

namespace {

using Direction = Mechanism::Direction;

struct SharedEnd {
  int at, of, from;  // points
  bool same_sense;   // both lines start there, or both end there
};

std::optional<SharedEnd> shared_end(const Direction& of, const Direction& from) {
  if (of.from == from.from) return SharedEnd{of.from, of.to, from.to, true};
  if (of.to == from.to) return SharedEnd{of.to, of.from, from.from, true};
  if (of.from == from.to) return SharedEnd{of.from, of.to, from.from, false};
  if (of.to == from.from) return SharedEnd{of.to, of.from, from.to, false};
  return std::nullopt;
}

/// Of a vector 1; of a line its length, which one body must keep constant.
double constant_length(const Definition& definition, const Direction& d) {
  if (!d.is_line()) return 1;
  const EquationWriter& w = definition.writer;
  for (const int r : w.rigid.of_point[d.from])
    if (std::ranges::binary_search(w.rigid.of_point[d.to], r))
      return nominal::length(w.mechanism, w.rigid.list[r], d);
  throw std::invalid_argument("coordinate '" + definition.coordinate.name +
                              "': no body carries both points of " + w.text(d) +
                              "; an angle needs a line of constant length");
}

void define_from_x_axis(const Definition& definition) {
  const auto& [w, c, value] = definition;
  const double length = constant_length(definition, c.of);
  if (c.of.is_line())
    definition.as<PlanarAngle>({w.point(c.of.from), w.point(c.of.to), value}, {length});
  else
    definition.as<PlanarDirection>({w.vector(c.of.vector), value});
}

void define_between_lines(const Definition& definition, double ratio) {
  const auto& [w, c, value] = definition;
  if (const auto shared = shared_end(c.of, c.from))
    definition.as<PlanarTurnAtPoint>(
        {w.point(shared->at), w.point(shared->of), w.point(shared->from), value},
        {shared->same_sense ? ratio : -ratio});
  else
    definition.as<PlanarTurn<true, true>>(
        {w.point(c.of.from), w.point(c.of.to), w.point(c.from.from), w.point(c.from.to), value},
        {ratio});
}

}  // namespace

void define_planar_angle(const Definition& definition) {
  const auto& [w, c, value] = definition;
  if (!c.from.is_given()) return define_from_x_axis(definition);
  const double length = constant_length(definition, c.of);
  const double ratio = length / constant_length(definition, c.from);
  if (c.of.is_line() && c.from.is_line())
    define_between_lines(definition, ratio);
  else if (c.of.is_line())
    definition.as<PlanarTurn<true, false>>(
        {w.point(c.of.from), w.point(c.of.to), w.vector(c.from.vector), value}, {ratio});
  else if (c.from.is_line())
    definition.as<PlanarTurn<false, true>>(
        {w.vector(c.of.vector), w.point(c.from.from), w.point(c.from.to), value}, {ratio});
  else
    definition.as<PlanarTurn<false, false>>({w.vector(c.of.vector), w.vector(c.from.vector), value},
                                            {ratio});
}

}  // namespace desmo
