#include "formulations/modelling/equations/equation_writer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <stdexcept>

#include "formulations/model/partition.h"
#include "formulations/modelling/equations/sliding_lines.h"

namespace desmo {

namespace {

template <class Points, class Position = std::identity>
double max_coordinate(const Points& points, Position position = {}) {
  double largest = 0;
  for (const auto& p : points)
    for (const double x : std::invoke(position, p)) largest = std::max(largest, std::abs(x));
  return largest;
}

template <int D>
Model write_all(EquationWriter& w) {
  write_body_equations<D>(w);
  if (w.framed) write_cut_joints(w);
  write_joint_equations(w);
  write_coordinate_equations<D>(w);
  write_coupling_equations(w);
  return w.release();
}

}  // namespace

EquationWriter::EquationWriter(const Mechanism& mechanism, const RigidBodies& bodies,
                               Coordinates coordinates, const FramedMechanism* frames)
    : mechanism(mechanism),
      rigid(bodies),
      framed(frames),
      reach(reach_of(mechanism)),
      coordinates_(std::move(coordinates)),
      farthest_(reach) {
  for (const RigidBody& body : bodies.list)
    farthest_ = std::max(farthest_, reach_of(mechanism, body, reach));
}

void EquationWriter::begin(int body, int other) {
  group_ = std::max(coordinates_.group_of_body[body], coordinates_.group_of_body[other]);
}

EntityId EquationWriter::add_fixed_vector(std::string name, const Mechanism::Vector& vector) {
  return coordinates_.model.add_fixed(EntityKind::vector, std::move(name),
                                      std::span(vector.direction).first(mechanism.dimension),
                                      std::span(vector.remainder).first(mechanism.dimension));
}

EntityId EquationWriter::add_variable(EntityKind kind, std::string name,
                                      std::span<const double> start, int body) {
  Model& m = coordinates_.model;
  while (m.has(name)) name += "'";  // an entity of the user may have that name
  const EntityId id = m.add(kind, std::move(name), start, coordinates_.group_of_body[body]);
  m.entities[id].internal = true;
  return id;
}

bool EquationWriter::rests(const Mechanism::Direction& d) const {
  const auto is_fixed = [&](EntityId e) { return coordinates_.model.entities[e].fixed; };
  return d.is_line() ? is_fixed(point(d.from)) && is_fixed(point(d.to))
                     : is_fixed(vector(d.vector));
}

bool EquationWriter::note_product(const Mechanism::Direction& a, const Mechanism::Direction& b,
                                  double product, double magnitude) {
  if (rests(a) && rests(b)) return true;
  const auto key = [&product](const Mechanism::Direction& d) {
    if (!d.is_line()) return Key{0, d.vector, d.vector};
    if (d.from > d.to) product = -product;  // the key is that of the line in the opposite sense
    return Key{1, std::min(d.from, d.to), std::max(d.from, d.to)};
  };
  const Key first = key(a), second = key(b);
  const auto [it, is_new] =
      products_.try_emplace(std::minmax(first, second), Product{product, magnitude});
  const Product& recorded = it->second;
  return is_new || !is_rounding(recorded.value - product, std::max(recorded.magnitude, magnitude));
}

std::string EquationWriter::text(const Mechanism::Direction& d) const {
  return d.is_line() ? mechanism.points[d.from].name + "-" + mechanism.points[d.to].name
                     : mechanism.vectors[d.vector].name;
}

Model EquationWriter::release() {
  // So far, only equations between constants are left out. They come last.
  std::ranges::stable_sort(coordinates_.model.constraints, {},
                           [](const Constraint& c) { return std::pair(c.group, c.left_out != 0); });
  return std::move(coordinates_.model);
}

void EquationWriter::constrain(EquationSource source, std::string name, int kind,
                               std::span<const EntityId> operands,
                               std::span<const Derived> dimensions, int derives) {
  Constraint made{std::move(name),
                  kind,
                  {operands.begin(), operands.end()},
                  {dimensions.begin(), dimensions.end()},
                  no_position};
  made.derives = derives;
  made.source = source;
  for (const EntityId e : operands)
    made.group = std::max(made.group, coordinates_.model.entities.at(e).group);
  if (made.group < 0) {
    if (holds_to_rounding(coordinates_.model, made, farthest_)) return;
    if (group_ < 0) throw std::logic_error("'" + made.name + "' is of no group");
    made.group = group_;
    made.left_out = (1u << rows(made)) - 1;
  }
  coordinates_.model.add(std::move(made));
}

double reach_of(const Mechanism& mechanism) {
  return max_coordinate(mechanism.points, &Mechanism::Point::position);
}

double reach_of(const Mechanism& mechanism, const RigidBody& body, double reach) {
  const auto& own = mechanism.bodies[body.bodies.front()].own;
  return own ? max_coordinate(own->points, Mechanism::rounded) : reach;
}

bool is_rounding(double value, double magnitude) {
  return std::abs(value) <= max_rounding * magnitude;
}

bool writes_offset(const EquationWriter& w, const Mechanism::Joint& j) {
  return w.framed || !declares_distance(w.mechanism, j) ||
         drawn_off(w.mechanism, w.rigid, w.reach, j.line(), j.vectors[0]) > 0;
}

namespace {

/// Marks points and vectors that were added after those of the mechanism as internal. Removes
/// them from the lists of groups.
void mark_internal(Coordinates& coordinates, const Mechanism& mechanism) {
  Model& m = coordinates.model;
  for (std::size_t p = mechanism.points.size(); p < coordinates.points.size(); ++p)
    m.entities[coordinates.points[p]].internal = true;
  for (std::size_t v = mechanism.vectors.size(); v < coordinates.vectors.size(); ++v)
    m.entities[coordinates.vectors[v]].internal = true;
  for (Group& group : m.groups)
    std::erase_if(group.entities, [&](EntityId e) { return m.entities[e].internal; });
}

/// Makes the candidates of a mechanism to which points and vectors may have been added after those
/// of `original`.
Model make_candidates(const Mechanism& drawn, const RigidBodies& rigid, const Structure& structure,
                      const std::vector<Motion>& motions, Modelling modelling,
                      const Mechanism& original) {
  const std::optional<FramedMechanism> changed =
      has_frames(modelling) ? put_frames(drawn, rigid, structure, modelling)
                            : with_plane_normals(drawn, rigid);
  const Mechanism& mechanism = changed ? changed->mechanism : drawn;
  const RigidBodies& bodies = changed ? changed->rigid : rigid;
  Coordinates coordinates = make_coordinates(mechanism, bodies, structure, motions, modelling);
  mark_internal(coordinates, original);
  EquationWriter w(mechanism, bodies, std::move(coordinates),
                   has_frames(modelling) ? &*changed : nullptr);
  Model model = original.dimension == 2 ? write_all<2>(w) : write_all<3>(w);
  keep_derivations(model);
  return model;
}

}  // namespace

Model make_candidate_equations(const Mechanism& mechanism, const RigidBodies& rigid,
                               const Structure& structure, const std::vector<Motion>& motions,
                               Modelling modelling) {
  if (const auto drawn = with_lines_as_drawn(mechanism, rigid))
    return make_candidates(*drawn, find_rigid_bodies(*drawn), structure, motions, modelling,
                           mechanism);
  return make_candidates(mechanism, rigid, structure, motions, modelling, mechanism);
}

}  // namespace desmo
