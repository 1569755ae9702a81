#include "formulations/modelling/equations/coordinate_equations.h"

#include <stdexcept>

#include "formulations/modelling/coordinates/definition.h"

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;

void require_along(const EquationWriter& w, const Mechanism::Coordinate& c) {
  const Mechanism& d = w.mechanism;
  const Vec s = nominal::direction(d, c.of), u = d.vectors[c.vector].direction;
  const double along = nominal::dot(s, u);
  const Vec off = s - Vec{along * u[0], along * u[1], along * u[2]};
  if (nominal::norm(off) > 1e-6 * nominal::size(d))
    throw std::invalid_argument("coordinate '" + c.name + "': " + w.text(c.of) + " is not along '" +
                                d.vectors[c.vector].name + "' in the nominal position");
}

template <int D>
void define_component(const Definition& definition) {
  const Mechanism::Coordinate& c = definition.coordinate;
  const EntityId point = definition.writer.point(c.point), value = definition.value;
  if (c.axis == 0)
    definition.as<Component<D, 0>>({point, value});
  else if (c.axis == 1)
    definition.as<Component<D, 1>>({point, value});
  else if constexpr (D == 3)
    definition.as<Component<3, 2>>({point, value});
}

template <int D>
void define(const Definition& definition) {
  using enum Mechanism::CoordinateType;
  const auto& [w, c, value] = definition;
  switch (c.type) {
    case distance:
      return definition.as<Distance<D>>({w.point(c.of.from), w.point(c.of.to), value});
    case along:
      require_along(w, c);
      return definition.as<Along<D>>(
          {w.point(c.of.from), w.point(c.of.to), w.vector(c.vector), value});
    case component:
      return define_component<D>(definition);
    case angle:
      return D == 2 ? define_planar_angle(definition) : define_spatial_angle(definition);
  }
}

}  // namespace

template <int D>
void write_coordinate_equations(EquationWriter& w) {
  const Coordinates& all = w.coordinates();
  for (std::size_t c = 0; c < all.measured.size(); ++c)
    define<D>({w, all.measured[c], all.coordinates[c]});
}

template void write_coordinate_equations<2>(EquationWriter&);
template void write_coordinate_equations<3>(EquationWriter&);

}  // namespace desmo
