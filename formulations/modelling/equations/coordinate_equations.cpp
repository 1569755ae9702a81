
#include <algorithm>
#include <array>
#include <optional>
#include <stdexcept>
#include <string>

#include "cases/mechanism/joint_forms.h"
#include "cases/numbers/space.h"
#include "formulations/modelling/contradiction_error.h"
#include "formulations/modelling/equations/equation_writer.h"
#include "formulations/modelling/equations/sliding_lines.h"

namespace desmo {

namespace {

/// The definition of a relative coordinate: a constraint between it and points or vectors.
struct Definition {
  EquationWriter& writer;
  const Mechanism::Coordinate& coordinate;
  EntityId value;  ///< entity of the coordinate

  /// Writes the definition as a constraint of this kind.
  template <class Kind>
  void as(const std::array<EntityId, Kind::operand_sizes.size()>& operands,
          const std::array<Derived, Kind::constants>& dimensions = {}) const {
    writer.constrain<Kind>(EquationSource::coordinate, coordinate.name + ": definition", operands,
                           dimensions);
  }
  /// Writes the definition; where bodies have frames, it derives the coordinate, the last operand.
  template <class Kind>
  void derived_as(const std::array<EntityId, Kind::operand_sizes.size()>& operands) const {
    if (!writer.framed) return as<Kind>(operands);
    writer.derive<Kind>(EquationSource::coordinate, coordinate.name + ": definition", operands, {},
                        static_cast<int>(operands.size()) - 1);
  }
};

using Direction = Mechanism::Direction;

/// The point `at` that two lines share, with the other point of each: `of` and `from`.
struct SharedEnd {
  int at, of, from;
  bool same_sense;  // both lines start there, or both end there
};

std::optional<SharedEnd> shared_end(const Direction& of, const Direction& from) {
  if (of.from == from.from) return SharedEnd{of.from, of.to, from.to, true};
  if (of.to == from.to) return SharedEnd{of.to, of.from, from.from, true};
  if (of.from == from.to) return SharedEnd{of.from, of.to, from.from, false};
  if (of.to == from.from) return SharedEnd{of.to, of.from, from.to, false};
  return std::nullopt;
}

/// Returns the first body that carries both points of a line and so keeps its length constant. For
/// a vector, returns the ground, since any body would do. Throws std::invalid_argument when no body
/// carries both points.
const RigidBody& body_of(const Definition& definition, const Direction& d) {
  const EquationWriter& w = definition.writer;
  if (!d.is_line()) return w.rigid.list.front();
  for (const int r : w.rigid.of_point[d.from])
    if (std::ranges::binary_search(w.rigid.of_point[d.to], r)) return w.rigid.list[r];
  throw std::invalid_argument(
      "coordinate '" + definition.coordinate.name + "': no body carries both points of " +
      w.text(d) +
      "; an angle needs a line of constant length: measure that of a body's "
      "line or vector");
}

void define_from_x_axis(const Definition& definition) {
  const auto& [w, c, value] = definition;
  if (c.of.is_line())
    definition.as<PlanarAngle>(
        {w.point(c.of.from), w.point(c.of.to), value},
        measured<PlanarAngle>(w.mechanism, 0, [&](const auto& drawing) {
          return std::array{drawing.origin(), drawing.direction(body_of(definition, c.of), c.of)};
        }));
  else
    definition.as<PlanarDirection>({w.vector(c.of.vector), value});
}

/// Returns the constant ratio of the lengths of two directions. Vectors have length 1.
Derived ratio_of_lengths(const Definition& definition) {
  const auto& [w, c, value] = definition;
  return measured<PlanarTurn<Between::lines_at_point>>(w.mechanism, 0, [&](const auto& drawing) {
    const auto span = [&](const Direction& d) {
      using Vec = decltype(drawing.origin());
      return d.is_line() ? drawing.direction(body_of(definition, d), d) : Vec{1, 0, 0};
    };
    return std::array{drawing.origin(), span(c.of), span(c.from)};
  })[0];
}

void define_between_lines(const Definition& definition, const Derived& ratio) {
  const auto& [w, c, value] = definition;
  if (const auto shared = shared_end(c.of, c.from))
    definition.as<PlanarTurn<Between::lines_at_point>>(
        {w.point(shared->at), w.point(shared->of), w.point(shared->from), value},
        {shared->same_sense ? ratio : -ratio});
  else
    definition.as<PlanarTurn<Between::line_and_line>>(
        {w.point(c.of.from), w.point(c.of.to), w.point(c.from.from), w.point(c.from.to), value},
        {ratio});
}

void define_planar_angle(const Definition& definition) {
  const auto& [w, c, value] = definition;
  if (!c.from.is_given()) return define_from_x_axis(definition);
  const Derived ratio = ratio_of_lengths(definition);
  if (c.of.is_line() && c.from.is_line())
    define_between_lines(definition, ratio);
  else if (c.of.is_line())
    definition.as<PlanarTurn<Between::line_and_vector>>(
        {w.point(c.of.from), w.point(c.of.to), w.vector(c.from.vector), value}, {ratio});
  else if (c.from.is_line())
    definition.as<PlanarTurn<Between::vector_and_line>>(
        {w.vector(c.of.vector), w.point(c.from.from), w.point(c.from.to), value}, {ratio});
  else
    definition.as<PlanarTurn<Between::vector_and_vector>>(
        {w.vector(c.of.vector), w.vector(c.from.vector), value}, {ratio});
}

void define_spatial_angle(const Definition& definition) {
  const auto& [w, c, value] = definition;
  const EntityId from = w.vector(c.from.vector), towards = w.vector(c.towards.vector);
  if (c.of.is_line()) {
    const std::array operands{from, towards, w.point(c.of.from), w.point(c.of.to), value};
    c.opposite ? definition.as<FrameAngle<-1, DirectionOf::line>>(operands)
               : definition.as<FrameAngle<1, DirectionOf::line>>(operands);
  } else {
    const std::array operands{from, towards, w.vector(c.of.vector), value};
    c.opposite ? definition.as<FrameAngle<-1, DirectionOf::vector>>(operands)
               : definition.as<FrameAngle<1, DirectionOf::vector>>(operands);
  }
}

void require_along(const EquationWriter& w, const Mechanism::Coordinate& c) {
  const Mechanism& mechanism = w.mechanism;
  const double distance = drawn_off(mechanism, w.rigid, w.reach, c.of, c.vector);
  if (distance <= max_off_line * nominal::extent(mechanism)) return;
  const bool is_of_joint =
      std::ranges::count(mechanism.coordinates, c.name, &Mechanism::Coordinate::name) == 0;
  const std::string name =
      is_of_joint ? "joint '" + c.name.substr(0, c.name.rfind('/')) : "coordinate '" + c.name;
  throw ContradictionError(
      [text = name + "': " + w.text(c.of) + " is not along '" + mechanism.vectors[c.vector].name +
              "' in the nominal position: it is off by ",
       distance](const DisplayUnits& units) {
        return text + in_unit(distance, units.length) +
               "; draw it along that, or place one of the bodies by \"at\"";
      },
      mechanism.length_unit);
}

template <int D>
void define_component(const Definition& definition) {
  const Mechanism::Coordinate& c = definition.coordinate;
  const std::array operands{definition.writer.point(c.point), definition.value};
  if (c.axis == 0)
    definition.derived_as<Component<D, 0>>(operands);
  else if (c.axis == 1)
    definition.derived_as<Component<D, 1>>(operands);
  else if constexpr (D == 3)
    definition.derived_as<Component<3, 2>>(operands);
}

/// Returns whether the tree or equations of a joint keep the points of a distance along its vector,
/// or at a constant offset.
bool is_kept_along(const EquationWriter& w, const Mechanism::Coordinate& c) {
  for (int i = 0; i < static_cast<int>(w.mechanism.joints.size()); ++i) {
    const Mechanism::Joint& j = w.mechanism.joints[i];
    if (!is_distance_of(j, c)) continue;
    if (w.mechanism.dimension == 2) return writes_offset(w, j);
    return w.framed && (w.framed->tree.is_of_tree[i] ||
                        std::ranges::count(w.framed->lines, i, &NormalLine::joint) > 0);
  }
  return false;
}

template <int D>
void define(const Definition& definition) {
  using enum Mechanism::CoordinateType;
  const auto& [w, c, value] = definition;
  switch (c.type) {
    case distance:
      return definition.as<Distance<D>>({w.point(c.of.from), w.point(c.of.to), value});
    case along:
      if (is_kept_along(w, c))
        return definition.derived_as<Reach<D>>(
            {w.point(c.of.from), w.point(c.of.to), w.vector(c.vector), value});
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
  std::vector<bool> is_variable(all.measured.size(), false);  // variables of tree joints
  if (w.framed)
    for (const DerivedFrame& frame : w.framed->frames)
      for (const int c : {frame.angle, frame.travel})
        if (c >= 0) is_variable[c] = true;
  for (const Mechanism::Coordinate& c : all.measured)
    if (c.type == Mechanism::CoordinateType::along && (D == 3 || !is_kept_along(w, c)))
      require_along(w, c);
  for (std::size_t c = 0; c < all.measured.size(); ++c)
    if (!is_variable[c]) define<D>({w, all.measured[c], all.coordinates[c]});
}

template void write_coordinate_equations<2>(EquationWriter&);
template void write_coordinate_equations<3>(EquationWriter&);

}  // namespace desmo
