#include "formulations/modelling/coordinates.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace desmo {

namespace {

using nominal::Vec;
using Direction = Description::Direction;

/// I, II, III, IV, … as the paper numbers its groups.
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

/// What the names of the bodies have in common up to a "/": "axle1/".
std::string common_prefix(const std::vector<std::string>& names) {
  std::string prefix = names.front();
  for (const std::string& name : names)
    prefix.resize(std::ranges::mismatch(prefix, name).in1 - prefix.begin());
  const std::size_t slash = prefix.rfind('/');
  return slash == std::string::npos ? "" : prefix.substr(0, slash + 1);
}

class Modeller {
 public:
  Modeller(const Description& d, const RigidBodies& rigid, const Structure& structure,
           const std::vector<Motion>& motions)
      : d_(d), rigid_(rigid), structure_(structure), motions_(motions), m_(result_.mechanism) {
    result_.points.assign(d.points.size(), -1);
    result_.vectors.assign(d.vectors.size(), -1);
    m_.name = d.name;
    m_.length_unit = d.length_unit;
  }

  Coordinates make() {
    add_ground();
    place_entities();
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
      result_.points[p] =
          m_.add_fixed(EntityKind::point, d_.points[p].name, components(d_.points[p].position));
    for (const int v : ground.vectors) {
      const std::string& name = d_.vectors[v].name;
      const std::span<const double> value = components(d_.vectors[v].direction);
      if (rigid_.of_vector[v].size() == 1) {
        result_.vectors[v] = m_.add_fixed(EntityKind::vector, name, value);
        continue;
      }
      const GroupId g = m_.add_group("ground/" + name, {d_.bodies.front().name});
      m_.groups[g].constant = true;
      result_.vectors[v] = m_.add(EntityKind::vector, name, value, g);
      m_.groups[g].entities = {result_.vectors[v]};
    }
    constant_groups_ = static_cast<int>(m_.groups.size());
  }

  /// The structural group that finds an entity carried by these bodies.
  template <class InBasis>
  int finder(const std::vector<int>& carriers, bool measured_by_driver, InBasis&& in_basis) const {
    std::vector<int> building, following;  // groups of the bodies that build on it, and the others
    for (const int r : carriers)
      (in_basis(rigid_.list[r].basis) ? building : following).push_back(structure_.of_body[r]);
    std::ranges::sort(building);
    std::ranges::sort(following);
    if (building.empty()) return following.front();
    if (following.empty() || building.front() <= following.front()) return building.front();
    // An earlier body carries it, too. It can wait for the later group that builds on it, when
    // that is the only one and nothing needs it before.
    const bool one_builds = building.front() == building.back();
    const bool needed_before =
        measured_by_driver ||
        std::ranges::upper_bound(following, building.front()) - following.begin() > 1;
    return one_builds && !needed_before ? building.front() : following.front();
  }

  void place_entities() {
    std::vector<bool> point_drives(d_.points.size(), false),
        vector_drives(d_.vectors.size(), false);
    for (const Description::Coordinate& c : d_.coordinates) {
      if (!c.driven) continue;
      for (const Direction* direction : {&c.of, &c.from, &c.towards}) {
        if (direction->is_segment())
          point_drives[direction->from] = point_drives[direction->to] = true;
        else if (direction->is_given())
          vector_drives[direction->vector] = true;
      }
      if (c.point >= 0) point_drives[c.point] = true;
      if (c.vector >= 0) vector_drives[c.vector] = true;
    }
    found_points_.assign(d_.points.size(), -1);
    found_vectors_.assign(d_.vectors.size(), -1);
    for (int p = 0; p < static_cast<int>(d_.points.size()); ++p)
      if (result_.points[p] < 0 && !rigid_.of_point[p].empty())
        found_points_[p] = finder(rigid_.of_point[p], point_drives[p],
                                  [&](const Basis& b) { return b.has_point(p); });
    for (int v = 0; v < static_cast<int>(d_.vectors.size()); ++v)
      if (result_.vectors[v] < 0 && !rigid_.of_vector[v].empty())
        found_vectors_[v] = finder(rigid_.of_vector[v], vector_drives[v],
                                   [&](const Basis& b) { return b.has_vector(v); });
  }

  /// Relative coordinates: those declared, and the distances of spatial sliding joints.
  void place_coordinates() {
    result_.measured = d_.coordinates;
    const DeclaredSlides declared(d_);
    for (const Description::Joint& j : d_.joints)
      if (d_.dimension == 3 && DeclaredSlides::slides(j) && !declared.contain(j)) {
        Description::Coordinate& c = result_.measured.emplace_back();
        c.name = j.name + "/distance";
        c.type = Description::CoordinateType::along;
        c.of = {-1, j.points[0], j.points[1]};
        c.vector = j.vectors[0];
      }
    result_.coordinates.assign(result_.measured.size(), -1);
    measured_by_.resize(structure_.groups.size());
    for (std::size_t c = 0; c < result_.measured.size(); ++c) {
      const int group = finder(result_.measured[c]);
      if (group < 0)
        throw std::invalid_argument(
            "coordinate '" + result_.measured[c].name +
            "' measures nothing that can move; measure something that moves, or "
            "leave it out");
      measured_by_[group].push_back(static_cast<int>(c));
    }
  }

  /// The last structural group that finds something a coordinate is measured from; -1 when none.
  int finder(const Description::Coordinate& c) const {
    int last = -1;
    for (const Direction* d : {&c.of, &c.from, &c.towards}) {
      if (d->is_segment())
        last = std::max({last, found_points_[d->from], found_points_[d->to]});
      else if (d->is_given())
        last = std::max(last, found_vectors_[d->vector]);
    }
    if (c.vector >= 0) last = std::max(last, found_vectors_[c.vector]);
    if (c.point >= 0) last = std::max(last, found_points_[c.point]);
    return last;
  }

  void add_groups() {
    std::map<std::string, int> numbers;
    for (std::size_t position = 0; position < structure_.groups.size(); ++position) {
      const StructuralGroup& group = structure_.groups[position];
      std::vector<int> order;
      for (const int r : group.bodies)
        order.insert(order.end(), rigid_.list[r].bodies.begin(), rigid_.list[r].bodies.end());
      std::ranges::sort(order);
      std::vector<std::string> bodies;
      for (const int b : order) bodies.push_back(d_.bodies[b].name);
      const std::string prefix = common_prefix(bodies);
      const GroupId g = m_.add_group(prefix + "SG-" + roman(++numbers[prefix]), std::move(bodies));
      for (const int a : group.after) m_.groups[g].after.push_back(constant_groups_ + a);
      for (const int b : order) add_entities(b, static_cast<int>(position), g);
      for (const int c : measured_by_[position]) {
        const bool angle = result_.measured[c].type == Description::CoordinateType::angle;
        const double start = result_.measured[c].estimate ? *result_.measured[c].estimate
                                                          : measure(result_.measured[c]);
        result_.coordinates[c] = m_.add(angle ? EntityKind::angle : EntityKind::distance,
                                        result_.measured[c].name, std::array{start}, g);
      }
    }
  }

  /// Of what a body carries, that which this group finds.
  void add_entities(int body, int position, GroupId g) {
    for (const int p : d_.bodies[body].points)
      if (result_.points[p] < 0 && found_points_[p] == position)
        result_.points[p] =
            m_.add(EntityKind::point, d_.points[p].name, components(d_.points[p].position), g);
    for (const int v : d_.bodies[body].vectors)
      if (result_.vectors[v] < 0 && found_vectors_[v] == position)
        result_.vectors[v] =
            m_.add(EntityKind::vector, d_.vectors[v].name, components(d_.vectors[v].direction), g);
  }

  void drive() {
    std::size_t motion = 0;
    for (std::size_t c = 0; c < d_.coordinates.size(); ++c)
      if (d_.coordinates[c].driven) m_.drive(result_.coordinates[c], motions_.at(motion++));
  }

  /// As the paper counts: what the bodies carry and the joints name, unless a later group finds it.
  void list_group_entities() {
    std::vector<std::set<EntityId>> seen(m_.groups.size());
    const auto list = [&](GroupId g, EntityId e) {
      if (m_.entities[e].group <= g && seen[g].insert(e).second) m_.groups[g].entities.push_back(e);
    };
    const auto group_of = [&](int body) {
      const int r = rigid_.of_body[body];
      return r == 0 ? -1 : constant_groups_ + structure_.of_body[r];
    };
    for (int b = 1; b < static_cast<int>(d_.bodies.size()); ++b) {
      const GroupId g = group_of(b);
      if (g < 0) continue;
      for (const int p : d_.bodies[b].points) list(g, result_.points[p]);
      for (const int v : d_.bodies[b].vectors) list(g, result_.vectors[v]);
    }
    for (const Description::Joint& j : d_.joints) {
      const GroupId g = std::max(group_of(j.bodies[0]), group_of(j.bodies[1]));
      if (g < 0) continue;
      for (const int p : j.points) list(g, result_.points[p]);
      for (const int v : j.vectors) list(g, result_.vectors[v]);
    }
    for (const EntityId c : result_.coordinates) list(m_.entities[c].group, c);
  }

  /// The value of a coordinate in the nominal position.
  double measure(const Description::Coordinate& c) const {
    using enum Description::CoordinateType;
    if (c.type == component) return d_.points[c.point].position[c.axis];
    const Vec w = nominal::direction(d_, c.of);
    if (c.type == distance) return nominal::norm(w);
    if (c.type == along) return nominal::dot(w, d_.vectors[c.vector].direction);
    if (d_.dimension == 3) {
      const double cosine = nominal::dot(w, nominal::direction(d_, c.from));
      return std::atan2(nominal::dot(w, nominal::direction(d_, c.towards)),
                        c.opposite ? -cosine : cosine);
    }
    const Vec x = c.from.is_given() ? nominal::direction(d_, c.from) : Vec{1, 0, 0};
    return std::atan2(x[0] * w[1] - x[1] * w[0], nominal::dot(x, w));
  }

  std::span<const double> components(const Vec& v) const {
    return {v.data(), static_cast<std::size_t>(d_.dimension)};
  }

  const Description& d_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  const std::vector<Motion>& motions_;
  Coordinates result_;
  Mechanism& m_;  // result_.mechanism
  int constant_groups_ = 0;
  std::vector<int> found_points_, found_vectors_;  // structural group that finds each
  std::vector<std::vector<int>> measured_by_;      // positions in `measured`, by structural group
};

}  // namespace

DeclaredSlides::DeclaredSlides(const Description& d) {
  for (const Description::Coordinate& c : d.coordinates)
    if (c.type == Description::CoordinateType::along)
      declared_.insert({c.vector, std::min(c.of.from, c.of.to), std::max(c.of.from, c.of.to)});
}

bool DeclaredSlides::slides(const Description::Joint& j) {
  using enum Description::JointType;
  return j.type == prismatic || j.type == cylindrical || j.type == revolute_on_slider;
}

bool DeclaredSlides::contain(const Description::Joint& j) const {
  if (!slides(j)) return false;
  const auto [low, high] = std::minmax(j.points[0], j.points[1]);
  return declared_.contains({j.vectors[0], low, high});
}

Coordinates make_coordinates(const Description& d, const RigidBodies& rigid,
                             const Structure& structure, const std::vector<Motion>& motions) {
  return Modeller(d, rigid, structure, motions).make();
}

}  // namespace desmo
