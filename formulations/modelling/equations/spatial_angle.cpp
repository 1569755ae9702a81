#include <array>
#include <cmath>
#include <stdexcept>

#include "formulations/modelling/coordinates/definition.h"

namespace desmo {

namespace {

using nominal::Vec;

void require_in_plane(const EquationWriter& w, const Mechanism::Coordinate& c) {
  const Mechanism& d = w.mechanism;
  const Vec u = nominal::direction(d, c.of), x = nominal::direction(d, c.from),
            z = nominal::direction(d, c.towards);
  const Vec normal{x[1] * z[2] - x[2] * z[1], x[2] * z[0] - x[0] * z[2], x[0] * z[1] - x[1] * z[0]};
  if (std::abs(nominal::dot(normal, u)) > 1e-6 * nominal::norm(u))
    throw std::invalid_argument("coordinate '" + c.name + "': " + w.text(c.of) +
                                " is not in the plane of " + w.text(c.from) + " and " +
                                w.text(c.towards) + " in the nominal position");
}

}  // namespace

void define_spatial_angle(const Definition& definition) {
  const auto& [w, c, value] = definition;
  require_in_plane(w, c);
  const EntityId from = w.vector(c.from.vector), towards = w.vector(c.towards.vector);
  if (c.of.is_line()) {
    const std::array operands{from, towards, w.point(c.of.from), w.point(c.of.to), value};
    c.opposite ? definition.as<FrameAngle<-1, true>>(operands)
               : definition.as<FrameAngle<1, true>>(operands);
  } else {
    const std::array operands{from, towards, w.vector(c.of.vector), value};
    c.opposite ? definition.as<FrameAngle<-1, false>>(operands)
               : definition.as<FrameAngle<1, false>>(operands);
  }
}

}  // namespace desmo
