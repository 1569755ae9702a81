#include "formulations/modelling/equations/equation_writer.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <optional>
#include <span>

#include "formulations/model/derivations.h"

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
CandidateEquations write_all(EquationWriter& w) {
  write_body_equations<D>(w);
  if (w.framed) write_cut_joints<D>(w);
  write_joint_equations(w);
  write_coordinate_equations<D>(w);
  write_coupling_equations(w);
  return w.release();
}

}  // namespace

EquationWriter::EquationWriter(const Mechanism& d, const RigidBodies& bodies,
                               Coordinates coordinates, const FramedMechanism* frames)
    : mechanism(d),
      rigid(bodies),
      framed(frames),
      reach(max_coordinate(d.points, &Mechanism::Point::position)),
      coordinates_(std::move(coordinates)) {}

double EquationWriter::reach_of(const RigidBody& body) const {
  const auto& own = mechanism.bodies[body.bodies.front()].own;
  return own ? max_coordinate(own->points, Mechanism::rounded) : reach;
}

EntityId EquationWriter::add_fixed_vector(std::string name, const Mechanism::Vector& vector) {
  return coordinates_.model.add_fixed(EntityKind::vector, std::move(name),
                                      std::span(vector.direction).first(mechanism.dimension),
                                      std::span(vector.remainder).first(mechanism.dimension));
}

EntityId EquationWriter::add_variable(EntityKind kind, std::string name,
                                      std::span<const double> start, int body) {
  Model& m = coordinates_.model;
  while (std::ranges::count(m.entities, name, &Entity::name) > 0) name += "'";  // a user's
  const EntityId id = m.add(kind, std::move(name), start, coordinates_.group_of_body[body]);
  m.entities[id].internal = true;
  return id;
}

bool EquationWriter::note_product(const Mechanism::Direction& a, const Mechanism::Direction& b,
                                  double product) {
  const auto key = [](const Mechanism::Direction& d) {
    return d.is_line() ? Key{1, std::min(d.from, d.to), std::max(d.from, d.to)}
                       : Key{0, d.vector, d.vector};
  };
  const auto [it, is_new] = products_.emplace(std::minmax({key(a), key(b)}), product);
  return is_new ||
         std::abs(std::abs(it->second) - std::abs(product)) > 1e-12 * std::max(1.0, reach * reach);
}

std::string EquationWriter::text(const Mechanism::Direction& d) const {
  return d.is_line() ? mechanism.points[d.from].name + "-" + mechanism.points[d.to].name
                     : mechanism.vectors[d.vector].name;
}

CandidateEquations EquationWriter::release() {
  Model& m = coordinates_.model;
  std::vector<int> order(origins_.size());
  std::iota(order.begin(), order.end(), 0);
  std::ranges::stable_sort(order, {}, [&](int c) { return m.constraints[c].group; });
  std::vector<Constraint> constraints;
  std::vector<Origin> origins;
  for (const int c : order) {
    constraints.push_back(std::move(m.constraints[c]));
    origins.push_back(origins_[c]);
  }
  m.constraints = std::move(constraints);
  return {std::move(m), std::move(origins)};
}

void EquationWriter::constrain(Origin origin, std::string name, int kind,
                               std::span<const EntityId> operands,
                               std::span<const Derived> dimensions, int derives) {
  Constraint made{std::move(name), kind, {operands.begin(), operands.end()}, {}, no_position};
  made.derives = derives;
  for (const EntityId e : operands)
    made.group = std::max(made.group, coordinates_.model.entities.at(e).group);
  if (made.group < 0) return;
  for (const Derived& d : dimensions) {
    made.constants.push_back(d.value);
    made.remainders.push_back(d.remainder());
  }
  coordinates_.model.add(std::move(made));
  origins_.push_back(origin);
}

bool is_rounding(double value, double magnitude) {
  return std::abs(value) <= 16 * std::numeric_limits<double>::epsilon() * magnitude;
}

namespace {

/// What was added to a mechanism serves the model alone.
void mark_internal(Coordinates& coordinates, const Mechanism& d) {
  const auto mark = [&](const std::vector<EntityId>& entities, std::size_t own) {
    for (std::size_t i = own; i < entities.size(); ++i) {
      coordinates.model.entities[entities[i]].internal = true;
      for (Group& group : coordinates.model.groups) std::erase(group.entities, entities[i]);
    }
  };
  mark(coordinates.points, d.points.size());
  mark(coordinates.vectors, d.vectors.size());
}

}  // namespace

CandidateEquations make_candidate_equations(const Mechanism& d, const RigidBodies& rigid,
                                            const Structure& structure,
                                            const std::vector<Motion>& motions,
                                            Modelling modelling) {
  std::optional<FramedMechanism> framed;
  if (has_frames(modelling)) framed = put_frames(d, rigid, structure, modelling);
  const Mechanism& mechanism = framed ? framed->mechanism : d;
  const RigidBodies& bodies = framed ? framed->rigid : rigid;
  Coordinates coordinates = make_coordinates(mechanism, bodies, structure, motions, modelling);
  mark_internal(coordinates, d);
  EquationWriter w(mechanism, bodies, std::move(coordinates), framed ? &*framed : nullptr);
  CandidateEquations candidates = d.dimension == 2 ? write_all<2>(w) : write_all<3>(w);
  keep_derivations(candidates.model);
  return candidates;
}

}  // namespace desmo
