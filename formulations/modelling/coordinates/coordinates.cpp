#include "formulations/modelling/coordinates/coordinates.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/drawing.h"
#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/coordinates/placement.h"

namespace desmo {

namespace {

/// Returns a number in Roman digits, from 4000 on in Arabic ones.
std::string roman(int n) {
  if (n >= 4000) return std::to_string(n);
  static constexpr std::pair<int, const char*> digits[] = {
      {1000, "M"}, {900, "CM"}, {500, "D"}, {400, "CD"}, {100, "C"}, {90, "XC"}, {50, "L"},
      {40, "XL"},  {10, "X"},   {9, "IX"},  {5, "V"},    {4, "IV"},  {1, "I"}};
  std::string text;
  for (const auto& [value, digit] : digits)
    for (; n >= value; n -= value) text += digit;
  return text;
}

/// Returns the longest common prefix of names that ends in "/", such as "axle1/", or nothing.
std::string common_prefix(const std::vector<std::string>& names) {
  std::string prefix = names.front();
  for (const std::string& name : names)
    prefix.resize(std::ranges::mismatch(prefix, name).in1 - prefix.begin());
  const std::size_t slash = prefix.rfind('/');
  return slash == std::string::npos ? "" : prefix.substr(0, slash + 1);
}

using nominal::Vec;

class Modeller {
 public:
  Modeller(const Mechanism& mechanism, const RigidBodies& rigid, const Structure& structure,
           const std::vector<Motion>& motions, Modelling modelling)
      : mechanism_(mechanism),
        rigid_(rigid),
        structure_(structure),
        placement_(place_entities(mechanism, rigid, structure, !has_frames(modelling))),
        motions_(motions),
        m_(result_.model) {
    result_.points.assign(mechanism.points.size(), -1);
    result_.vectors.assign(mechanism.vectors.size(), -1);
    m_.name = mechanism.name;
    m_.length_unit = mechanism.length_unit;
    m_.modelling = modelling;
  }

  Coordinates make() {
    add_ground();
    place_coordinates();
    add_groups();
    drive();
    list_group_entities();
    return std::move(result_);
  }

 private:
  void add_ground() {
    const RigidBody& ground = rigid_.list.front();
    for (const int p : ground.points)
      result_.points[p] = m_.add_fixed(
          EntityKind::point, mechanism_.points[p].name, components(mechanism_.points[p].position),
          std::span(mechanism_.points[p].remainder).first(mechanism_.dimension));
    for (const int v : ground.vectors) {
      const std::string& name = mechanism_.vectors[v].name;
      const std::span<const double> value = components(mechanism_.vectors[v].direction);
      if (rigid_.of_vector[v].size() == 1) {
        result_.vectors[v] =
            m_.add_fixed(EntityKind::vector, name, value,
                         std::span(mechanism_.vectors[v].remainder).first(mechanism_.dimension));
        continue;
      }
      const GroupId g = m_.add_group("ground/" + name, {mechanism_.bodies.front().name});
      m_.groups[g].constant = true;
      result_.vectors[v] = m_.add(EntityKind::vector, name, value, g);
      m_.groups[g].entities = {result_.vectors[v]};
    }
    constant_groups_ = static_cast<int>(m_.groups.size());
    for (const int group : structure_.of_body)
      result_.group_of_body.push_back(group < 0 ? no_position : constant_groups_ + group);
  }

  /// Assigns relative coordinates to structural groups: the declared ones, then the undeclared
  /// distances of spatial sliding joints.
  void place_coordinates() {
    result_.measured = mechanism_.coordinates;
    for (const Mechanism::Joint& j : mechanism_.joints)
      if (mechanism_.dimension == 3 && slides(j.type) && !declares_distance(mechanism_, j)) {
        Mechanism::Coordinate& c = result_.measured.emplace_back();
        c.name = j.name + "/distance";
        c.type = Mechanism::CoordinateType::along;
        c.of = j.line();
        c.vector = j.vectors[0];
      }
    result_.coordinates.assign(result_.measured.size(), -1);
    measured_by_.resize(structure_.groups.size());
    for (std::size_t c = 0; c < result_.measured.size(); ++c) {
      const int group = placement_.of(result_.measured[c]);
      if (group < 0)
        throw std::invalid_argument(
            "coordinate '" + result_.measured[c].name +
            "' measures nothing that can move; measure something that moves, or "
            "leave it out");
      measured_by_[group].push_back(static_cast<int>(c));
    }
  }

  /// Adds the groups. They are named as in the paper, SG-I, SG-II, …, after the common prefix of
  /// their bodies' names: "axle1/SG-I".
  void add_groups() {
    std::map<std::string, int> numbers;  // number of groups so far with each prefix
    for (std::size_t position = 0; position < structure_.groups.size(); ++position) {
      const StructuralGroup& group = structure_.groups[position];
      std::vector<int> order;
      for (const int r : group.bodies)
        order.insert(order.end(), rigid_.list[r].bodies.begin(), rigid_.list[r].bodies.end());
      std::ranges::sort(order);
      std::vector<std::string> bodies;
      for (const int b : order) bodies.push_back(mechanism_.bodies[b].name);
      const std::string prefix = common_prefix(bodies);
      const GroupId g = m_.add_group(prefix + "SG-" + roman(++numbers[prefix]), std::move(bodies));
      for (const int a : group.after) m_.groups[g].after.push_back(constant_groups_ + a);
      for (const int b : order) add_entities(b, static_cast<int>(position), g);
      for (const int c : measured_by_[position]) {
        const bool angle = result_.measured[c].type == Mechanism::CoordinateType::angle;
        const double start = result_.measured[c].estimate
                                 ? *result_.measured[c].estimate
                                 : Drawing<double>{mechanism_}.value(result_.measured[c]);
        result_.coordinates[c] = m_.add(angle ? EntityKind::angle : EntityKind::distance,
                                        result_.measured[c].name, std::array{start}, g);
      }
    }
  }

  /// Adds the points and vectors of a body that this group determines.
  void add_entities(int body, int position, GroupId g) {
    for (const int p : mechanism_.bodies[body].points)
      if (result_.points[p] < 0 && placement_.of_point[p] == position)
        result_.points[p] = m_.add(EntityKind::point, mechanism_.points[p].name,
                                   components(mechanism_.points[p].position), g);
    for (const int v : mechanism_.bodies[body].vectors)
      if (result_.vectors[v] < 0 && placement_.of_vector[v] == position)
        result_.vectors[v] = m_.add(EntityKind::vector, mechanism_.vectors[v].name,
                                    components(mechanism_.vectors[v].direction), g);
  }

  void drive() {
    std::size_t motion = 0;
    for (std::size_t c = 0; c < mechanism_.coordinates.size(); ++c)
      if (mechanism_.coordinates[c].driven) m_.drive(result_.coordinates[c], motions_.at(motion++));
  }

  /// Lists the entities of each group as the paper counts them: those of its bodies and joints, and
  /// its relative coordinates, unless a later group solves for them.
  void list_group_entities() {
    std::vector<std::set<EntityId>> seen(m_.groups.size());
    const auto list = [&](GroupId g, EntityId e) {
      if (m_.entities[e].group <= g && seen[g].insert(e).second) m_.groups[g].entities.push_back(e);
    };
    const auto group_of = [&](int body) { return result_.group_of_body[rigid_.of_body[body]]; };
    for (int b = 1; b < static_cast<int>(mechanism_.bodies.size()); ++b) {
      const GroupId g = group_of(b);
      if (g < 0) continue;
      for (const int p : mechanism_.bodies[b].points) list(g, result_.points[p]);
      for (const int v : mechanism_.bodies[b].vectors) list(g, result_.vectors[v]);
    }
    for (const Mechanism::Joint& j : mechanism_.joints) {
      const GroupId g = std::max(group_of(j.bodies[0]), group_of(j.bodies[1]));
      if (g < 0) continue;
      for (const int p : j.points) list(g, result_.points[p]);
      for (const int v : j.vectors) list(g, result_.vectors[v]);
    }
    for (const EntityId c : result_.coordinates) list(m_.entities[c].group, c);
  }

  std::span<const double> components(const Vec& v) const {
    return {v.data(), static_cast<std::size_t>(mechanism_.dimension)};
  }

  const Mechanism& mechanism_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  const Placement placement_;
  const std::vector<Motion>& motions_;
  Coordinates result_;
  Model& m_;  // result_.model
  int constant_groups_ = 0;
  // Relative coordinates of each structural group, as positions in `measured`.
  std::vector<std::vector<int>> measured_by_;
};

}  // namespace

bool is_distance_of(const Mechanism::Joint& j, const Mechanism::Coordinate& c) {
  return slides(j.type) && c.type == Mechanism::CoordinateType::along && c.vector == j.vectors[0] &&
         std::minmax({c.of.from, c.of.to}) == std::minmax({j.points[0], j.points[1]});
}

bool declares_distance(const Mechanism& mechanism, const Mechanism::Joint& j) {
  return std::ranges::any_of(mechanism.coordinates,
                             [&](const Mechanism::Coordinate& c) { return is_distance_of(j, c); });
}

Coordinates make_coordinates(const Mechanism& mechanism, const RigidBodies& rigid,
                             const Structure& structure, const std::vector<Motion>& motions,
                             Modelling modelling) {
  return Modeller(mechanism, rigid, structure, motions, modelling).make();
}

}  // namespace desmo
