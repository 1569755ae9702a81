#include "formulations/modelling/candidates.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>
#include <string>
#include <utility>

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;
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

template <int D>
class Modeller {
 public:
  Modeller(const Description& d, const RigidBodies& rigid, const Structure& structure,
           const std::vector<Motion>& motions)
      : d_(d),
        rigid_(rigid),
        structure_(structure),
        motions_(motions),
        point_(d.points.size(), -1),
        vector_(d.vectors.size(), -1) {
    for (const Description::Point& p : d.points)
      for (const double x : p.position) reach_ = std::max(reach_, std::abs(x));
    m_.name = d.name;
    m_.length_unit = d.length_unit;
  }

  Candidates make() {
    add_ground();
    place_entities();
    place_coordinates();
    add_groups();
    drive();
    list_group_entities();
    for (std::size_t r = 1; r < rigid_.list.size(); ++r) model_body(rigid_.list[r]);
    for (const Description::Joint& j : d_.joints) model_joint(j);
    for (std::size_t c = 0; c < measured_.size(); ++c) model_coordinate(c);
    sort_by_group();
    return {std::move(m_), std::move(origins_)};
  }

 private:
  static constexpr double eps = std::numeric_limits<double>::epsilon();

  // ---- entities ----

  void add_ground() {
    const RigidBody& ground = rigid_.list.front();
    for (const int p : ground.points)
      point_[p] = m_.add_fixed(EntityKind::point, d_.points[p].name, components(d_.points[p].position));
    for (const int v : ground.vectors) {
      const std::string& name = d_.vectors[v].name;
      const auto value = components(d_.vectors[v].direction);
      if (rigid_.of_vector[v].size() == 1) {
        vector_[v] = m_.add_fixed(EntityKind::vector, name, value);
        continue;
      }
      const GroupId g = m_.add_group("ground/" + name, {d_.bodies.front().name});
      m_.groups[g].constant = true;
      const EntityId held = m_.add_fixed(EntityKind::vector, "ground: " + name, value);
      vector_[v] = m_.add(EntityKind::vector, name, value, g);
      m_.groups[g].entities = {vector_[v]};
      constrain<Rigid<D, 0>>(Origin::ground, name + " on the ground", {vector_[v], held}, {});
    }
    constant_groups_ = static_cast<int>(m_.groups.size());
  }

  /// The structural group that finds an entity carried by these bodies.
  template <class InBasis>
  int finder(const std::vector<int>& carriers, InBasis&& in_basis) const {
    std::set<int> building, following;
    for (const int r : carriers)
      (in_basis(rigid_.list[r].basis) ? building : following).insert(structure_.of_body[r]);
    if (building.empty()) return *following.begin();
    const bool serves_one = building.size() == 1;
    if (!following.empty() && *following.begin() < *building.begin() && !serves_one)
      return *following.begin();
    return *building.begin();
  }

  void place_entities() {
    found_points_.assign(d_.points.size(), -1);
    found_vectors_.assign(d_.vectors.size(), -1);
    for (std::size_t p = 0; p < d_.points.size(); ++p)
      if (point_[p] < 0 && !rigid_.of_point[p].empty())
        found_points_[p] = finder(rigid_.of_point[p], [&](const Basis& b) {
          return b.has_point(static_cast<int>(p));
        });
    for (std::size_t v = 0; v < d_.vectors.size(); ++v)
      if (vector_[v] < 0 && !rigid_.of_vector[v].empty())
        found_vectors_[v] = finder(rigid_.of_vector[v], [&](const Basis& b) {
          return b.has_vector(static_cast<int>(v));
        });
  }

  /// Relative coordinates: those declared, and the distances of spatial sliding joints.
  void place_coordinates() {
    measured_ = d_.coordinates;
    for (const Description::Joint& j : d_.joints)
      if (D == 3 && slides(j) && !measures_slide(j)) {
        Description::Coordinate& c = measured_.emplace_back();
        c.name = j.name + "/distance";
        c.type = Description::CoordinateType::along;
        c.of = {-1, j.points[0], j.points[1]};
        c.vector = j.vectors[0];
      }
    coordinate_.assign(measured_.size(), -1);
    measured_by_.resize(structure_.groups.size());
    for (std::size_t c = 0; c < measured_.size(); ++c) {
      const int group = finder(measured_[c]);
      if (group < 0)
        throw std::invalid_argument("coordinate '" + measured_[c].name +
                                    "' measures nothing that can move");
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
        const bool angle = measured_[c].type == Description::CoordinateType::angle;
        const double start = measured_[c].estimate ? *measured_[c].estimate : measure(measured_[c]);
        coordinate_[c] = m_.add(angle ? EntityKind::angle : EntityKind::distance,
                                measured_[c].name, std::array{start}, g);
      }
    }
  }

  /// Of what a body carries, that which this group finds.
  void add_entities(int body, int position, GroupId g) {
    for (const int p : d_.bodies[body].points)
      if (point_[p] < 0 && found_points_[p] == position)
        point_[p] = m_.add(EntityKind::point, d_.points[p].name,
                           components(d_.points[p].position), g);
    for (const int v : d_.bodies[body].vectors)
      if (vector_[v] < 0 && found_vectors_[v] == position)
        vector_[v] = m_.add(EntityKind::vector, d_.vectors[v].name,
                            components(d_.vectors[v].direction), g);
  }

  void drive() {
    std::size_t motion = 0;
    for (std::size_t c = 0; c < d_.coordinates.size(); ++c)
      if (d_.coordinates[c].driven) m_.drive(coordinate_[c], motions_.at(motion++));
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
      for (const int p : d_.bodies[b].points) list(g, point_[p]);
      for (const int v : d_.bodies[b].vectors) list(g, vector_[v]);
    }
    for (const Description::Joint& j : d_.joints) {
      const GroupId g = std::max(group_of(j.bodies[0]), group_of(j.bodies[1]));
      if (g < 0) continue;
      for (const int p : j.points) list(g, point_[p]);
      for (const int v : j.vectors) list(g, vector_[v]);
    }
    for (const EntityId c : coordinate_) list(m_.entities[c].group, c);
  }

  // ---- equations ----

  template <class Kind>
  void constrain(Origin origin, std::string name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<double, Kind::constants>& constants) {
    const GroupId g = last_group({operands.begin(), operands.end()});
    if (g < 0) return;  // nothing in it can move
    m_.constrain<Kind>(g, std::move(name), operands, constants);
    origins_.push_back(origin);
  }

  /// Whether a product of two directions is met for the first time; bodies that share both state it
  /// once.
  bool is_new_product(const Direction& a, const Direction& b) {
    const auto key = [](const Direction& d) {
      return d.is_segment() ? std::array{1, std::min(d.from, d.to), std::max(d.from, d.to)}
                            : std::array{0, d.vector, d.vector};
    };
    return products_.insert(std::minmax(key(a), key(b))).second;
  }

  void model_body(const RigidBody& body) {
    const std::string name = d_.bodies[body.bodies.front()].name + ": ";
    const std::vector<Direction>& directions = body.basis.directions;
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t j = i; j < directions.size(); ++j)
        if (is_new_product(directions[i], directions[j]))
          keep_product(name, body, directions[i], directions[j]);
    for (const int p : body.points)
      if (!body.basis.has_point(p)) relate_point(name, body.basis, p);
    for (const int v : body.vectors)
      if (d_.vectors[v].along)
        keep_along(name, body, v);
      else if (!body.basis.has_vector(v))
        relate_vector(name, body.basis, v);
  }

  /// A constant product of two directions; vectors come before segments in a basis.
  void keep_product(const std::string& name, const RigidBody& body, const Direction& a,
                    const Direction& b) {
    const Vec u = nominal::direction(d_, a), v = nominal::direction(d_, b);
    if (!a.is_segment() && a.vector == b.vector)
      return constrain<Unit<D>>(Origin::body, name + text(a) + " unit", {vector_[a.vector]}, {});
    if (a.is_segment() && a.to == b.to) {
      const double length2 = body.length > 0 ? body.length * body.length : nominal::dot(u, u);
      return constrain<Length<D>>(Origin::body, name + text(a) + " length",
                                  {point_[a.from], point_[a.to]}, {length2});
    }
    if constexpr (D == 3) {
      const double product = snap(nominal::dot(u, v), scale(a) * scale(b));
      const std::string product_name = name + text(a) + " with " + text(b);
      if (a.is_segment()) {  // both from the same point: the distance of their ends says the same
        const Vec w = v - u;
        constrain<Length<3>>(Origin::body, name + text({-1, a.to, b.to}) + " length",
                             {point_[a.to], point_[b.to]}, {nominal::dot(w, w)});
      } else if (b.is_segment()) {
        constrain<Projection<3>>(Origin::body, product_name,
                                 {vector_[a.vector], point_[b.from], point_[b.to]}, {product});
      } else {
        constrain<Dot<3>>(Origin::body, product_name, {vector_[a.vector], vector_[b.vector]},
                          {product});
      }
    }
  }

  void keep_along(const std::string& name, const RigidBody& body, int v) {
    const auto& [from, to] = *d_.vectors[v].along;
    const double length = body.length > 0 ? body.length
                                          : nominal::norm(d_.points[to].position -
                                                          d_.points[from].position);
    constrain<Rigid<D, 1>>(Origin::body, name + d_.vectors[v].name + " along " + text({-1, from, to}),
                           {point_[to], point_[from], vector_[v]}, {length});
  }

  void relate_point(const std::string& name, const Basis& basis, int p) {
    relate(name + d_.points[p].name + " rigid", basis, point_[p],
           d_.points[p].position - d_.points[basis.origin].position, reach_, true);
  }

  void relate_vector(const std::string& name, const Basis& basis, int v) {
    relate(name + d_.vectors[v].name + " rigid", basis, vector_[v], d_.vectors[v].direction, 1,
           false);
  }

  /// target = [origin +] Σ cᵢ directionᵢ, nominally `offset` long from the origin.
  void relate(const std::string& name, const Basis& basis, EntityId target, const Vec& offset,
              double magnitude, bool is_point) {
    if constexpr (D == 2) {
      if (basis.directions.empty()) {  // a second name for the same place
        constrain<Rigid<2, 0>>(Origin::body, name, {target, point_[basis.origin]}, {});
        return;
      }
      const Direction& d = basis.directions.front();
      const Vec x = nominal::direction(d_, d);
      const double x2 = nominal::dot(x, x), least = magnitude / std::sqrt(x2);
      const std::array c{snap(nominal::dot(x, offset) / x2, least),
                         snap((x[0] * offset[1] - x[1] * offset[0]) / x2, least)};
      if (is_point && d.is_segment())
        constrain<PlanarRelation<true, true>>(Origin::body, name,
                                              {target, point_[d.from], point_[d.to]}, c);
      else if (is_point)
        constrain<PlanarRelation<true, false>>(
            Origin::body, name, {target, point_[basis.origin], vector_[d.vector]}, c);
      else if (d.is_segment())
        constrain<PlanarRelation<false, true>>(Origin::body, name,
                                               {target, point_[d.from], point_[d.to]}, c);
      else
        constrain<PlanarRelation<false, false>>(Origin::body, name, {target, vector_[d.vector]}, c);
    } else {
      relate_in_space(name, basis, target, offset, magnitude, is_point);
    }
  }

  void relate_in_space(const std::string& name, const Basis& basis, EntityId target,
                       const Vec& offset, double magnitude, bool is_point) {
    const int n = static_cast<int>(basis.directions.size());
    Eigen::Matrix<double, 3, Eigen::Dynamic, 0, 3, 3> directions(3, n);
    for (int k = 0; k < n; ++k) {
      const Vec x = nominal::direction(d_, basis.directions[k]);
      for (int i = 0; i < 3; ++i) directions(i, k) = x[i];
    }
    const Eigen::VectorXd c =
        n == 0 ? Eigen::VectorXd()
               : Eigen::VectorXd(directions.colPivHouseholderQr().solve(
                     Eigen::Vector3d(offset[0], offset[1], offset[2])));

    double of_origin = is_point ? 1 : 0;
    bool has_segments = false;
    std::vector<EntityId> terms;
    std::vector<double> coefficients;
    for (int k = 0; k < n; ++k) {
      const Direction& d = basis.directions[k];
      const double coefficient = snap(c[k], magnitude / directions.col(k).norm());
      if (coefficient == 0) continue;
      if (d.is_segment()) {
        has_segments = true;
        of_origin -= coefficient;
      }
      terms.push_back(d.is_segment() ? point_[d.to] : vector_[d.vector]);
      coefficients.push_back(coefficient);
    }
    if (is_point && !has_segments)
      return with_terms<3>(terms.size(), [&]<int T>() {
        std::array<EntityId, T + 2> operands{target, point_[basis.origin]};
        std::array<double, T> values{};
        std::copy_n(terms.begin(), T, operands.begin() + 2);
        std::copy_n(coefficients.begin(), T, values.begin());
        constrain<Rigid<3, T>>(Origin::body, name, operands, values);
      });
    of_origin = snap(of_origin, 1);
    if (of_origin != 0) {
      terms.insert(terms.begin(), point_[basis.origin]);
      coefficients.insert(coefficients.begin(), of_origin);
    }
    with_terms<4>(terms.size(), [&]<int T>() {
      if constexpr (T > 0) {
        std::array<EntityId, T + 1> operands{target};
        std::array<double, T> values{};
        std::copy_n(terms.begin(), T, operands.begin() + 1);
        std::copy_n(coefficients.begin(), T, values.begin());
        constrain<Combination<3, T>>(Origin::body, name, operands, values);
      }
    });
  }

  /// Calls f<T>() with T = terms, up to Most.
  template <int Most, class F>
  static void with_terms(std::size_t terms, F&& f) {
    [&]<int... T>(std::integer_sequence<int, T...>) {
      ((terms == T ? f.template operator()<T>() : void()), ...);
    }
    (std::make_integer_sequence<int, Most + 1>{});
  }

  void model_joint(const Description::Joint& j) {
    if (rigid_.of_body[j.bodies[0]] == rigid_.of_body[j.bodies[1]]) return;
    if constexpr (D == 2) {
      if (slides(j) && !measures_slide(j)) {
        const Vec u = d_.vectors[j.vectors[0]].direction;
        const Vec s = d_.points[j.points[1]].position - d_.points[j.points[0]].position;
        constrain<Offset>(Origin::joint, j.name + ": offset",
                          {vector_[j.vectors[0]], point_[j.points[0]], point_[j.points[1]]},
                          {snap(u[0] * s[1] - u[1] * s[0], reach_)});
      }
    } else if (j.type == Description::JointType::universal) {
      const Direction a{j.vectors[0]}, b{j.vectors[1]};
      if (is_new_product(a, b))
        constrain<Dot<3>>(
            Origin::joint, j.name + ": " + text(a) + " with " + text(b),
            {vector_[a.vector], vector_[b.vector]},
            {snap(nominal::dot(nominal::direction(d_, a), nominal::direction(d_, b)), 1)});
    }
  }

  void model_coordinate(std::size_t index) {
    using enum Description::CoordinateType;
    const Description::Coordinate& c = measured_[index];
    const EntityId value = coordinate_[index];
    const auto define = [&]<class Kind>(const std::array<EntityId, Kind::operand_sizes.size()>& o,
                                        const std::array<double, Kind::constants>& constants = {}) {
      constrain<Kind>(Origin::coordinate, c.name + ": definition", o, constants);
    };
    const auto a = [&] { return point_[c.of.from]; };
    const auto b = [&] { return point_[c.of.to]; };
    switch (c.type) {
      case distance:
        return define.template operator()<Distance<D>>({a(), b(), value});
      case along:
        require_along(c);
        return define.template operator()<Along<D>>({a(), b(), vector_[c.vector], value});
      case component:
        if (c.axis == 0)
          define.template operator()<Component<D, 0>>({point_[c.point], value});
        else if (c.axis == 1)
          define.template operator()<Component<D, 1>>({point_[c.point], value});
        else if constexpr (D == 3)
          define.template operator()<Component<3, 2>>({point_[c.point], value});
        return;
      case angle:
        if constexpr (D == 2)
          define_planar_angle(c, define, value);
        else
          define_spatial_angle(c, define, value);
    }
  }

  template <class Define>
  void define_planar_angle(const Description::Coordinate& c, Define& define, EntityId value) {
    const auto point = [&](int p) { return point_[p]; };
    const double length = constant_length(c, c.of);
    if (!c.from.is_given()) {
      if (c.of.is_segment())
        return define.template operator()<PlanarAngle>({point(c.of.from), point(c.of.to), value},
                                                       {length});
      return define.template operator()<PlanarDirection>({vector_[c.of.vector], value});
    }
    const double ratio = length / constant_length(c, c.from);
    if (c.of.is_segment() && c.from.is_segment()) {
      const auto shared = shared_end(c.of, c.from);
      if (!shared)
        return define.template operator()<PlanarTurn<true, true>>(
            {point(c.of.from), point(c.of.to), point(c.from.from), point(c.from.to), value},
            {ratio});
      return define.template operator()<PlanarTurnAtPoint>(
          {point(shared->at), point(shared->of), point(shared->from), value},
          {shared->same_sense ? ratio : -ratio});
    }
    if (c.of.is_segment())
      return define.template operator()<PlanarTurn<true, false>>(
          {point(c.of.from), point(c.of.to), vector_[c.from.vector], value}, {ratio});
    if (c.from.is_segment())
      return define.template operator()<PlanarTurn<false, true>>(
          {vector_[c.of.vector], point(c.from.from), point(c.from.to), value}, {ratio});
    define.template operator()<PlanarTurn<false, false>>(
        {vector_[c.of.vector], vector_[c.from.vector], value}, {ratio});
  }

  template <class Define>
  void define_spatial_angle(const Description::Coordinate& c, Define& define, EntityId value) {
    const Vec w = nominal::direction(d_, c.of), x = nominal::direction(d_, c.from),
              z = nominal::direction(d_, c.towards);
    const Vec normal{x[1] * z[2] - x[2] * z[1], x[2] * z[0] - x[0] * z[2],
                     x[0] * z[1] - x[1] * z[0]};
    if (std::abs(nominal::dot(normal, w)) > 1e-6 * nominal::norm(w))
      throw std::invalid_argument("coordinate '" + c.name + "': " + text(c.of) +
                                  " is not in the plane of " + text(c.from) + " and " +
                                  text(c.towards) + " in the nominal position");
    const EntityId from = vector_[c.from.vector], towards = vector_[c.towards.vector];
    if (c.of.is_segment()) {
      const std::array<EntityId, 5> operands{from, towards, point_[c.of.from], point_[c.of.to],
                                             value};
      c.opposite ? define.template operator()<FrameAngle<-1, true>>(operands)
                 : define.template operator()<FrameAngle<1, true>>(operands);
    } else {
      const std::array<EntityId, 4> operands{from, towards, vector_[c.of.vector], value};
      c.opposite ? define.template operator()<FrameAngle<-1, false>>(operands)
                 : define.template operator()<FrameAngle<1, false>>(operands);
    }
  }

  struct SharedEnd {
    int at, of, from;  ///< points
    bool same_sense;   ///< both segments start there, or both end there
  };
  static std::optional<SharedEnd> shared_end(const Direction& of, const Direction& from) {
    if (of.from == from.from) return SharedEnd{of.from, of.to, from.to, true};
    if (of.to == from.to) return SharedEnd{of.to, of.from, from.from, true};
    if (of.from == from.to) return SharedEnd{of.from, of.to, from.from, false};
    if (of.to == from.from) return SharedEnd{of.to, of.from, from.to, false};
    return std::nullopt;
  }

  /// Of a vector 1; of a segment its length, which one body must keep constant.
  double constant_length(const Description::Coordinate& c, const Direction& d) const {
    if (!d.is_segment()) return 1;
    for (const int r : rigid_.of_point[d.from])
      if (std::ranges::binary_search(rigid_.of_point[d.to], r)) {
        const double given = rigid_.list[r].length;
        return given > 0 ? given : nominal::norm(nominal::direction(d_, d));
      }
    throw std::invalid_argument("coordinate '" + c.name + "': no body carries both points of " +
                                text(d) + "; an angle needs a segment of constant length");
  }

  void require_along(const Description::Coordinate& c) const {
    const Vec s = nominal::direction(d_, c.of), u = d_.vectors[c.vector].direction;
    const double along = nominal::dot(s, u);
    const Vec off = s - Vec{along * u[0], along * u[1], along * u[2]};
    if (nominal::norm(off) > 1e-6 * nominal::size(d_))
      throw std::invalid_argument("coordinate '" + c.name + "': " + text(c.of) +
                                  " is not along '" + d_.vectors[c.vector].name +
                                  "' in the nominal position");
  }

  // ---- helpers ----

  static bool slides(const Description::Joint& j) {
    using enum Description::JointType;
    return j.type == prismatic || j.type == cylindrical || j.type == revolute_on_slider;
  }

  /// Whether a declared coordinate is the distance along a sliding joint, and so defines it.
  bool measures_slide(const Description::Joint& j) {
    if (slides_measured_.empty())
      for (const Description::Coordinate& c : d_.coordinates)
        if (c.type == Description::CoordinateType::along)
          slides_measured_.insert(
              {c.vector, std::min(c.of.from, c.of.to), std::max(c.of.from, c.of.to)});
    const auto [low, high] = std::minmax(j.points[0], j.points[1]);
    return slides_measured_.contains({j.vectors[0], low, high});
  }

  /// The last of the groups that find these entities; -1 when all are fixed.
  GroupId last_group(const std::vector<EntityId>& operands) const {
    GroupId g = -1;
    for (const EntityId e : operands) g = std::max(g, m_.entities.at(e).group);
    return g;
  }

  /// The value of a coordinate in the nominal position.
  double measure(const Description::Coordinate& c) const {
    using enum Description::CoordinateType;
    if (c.type == component) return d_.points[c.point].position[c.axis];
    const Vec w = nominal::direction(d_, c.of);
    if (c.type == distance) return nominal::norm(w);
    if (c.type == along) return nominal::dot(w, d_.vectors[c.vector].direction);
    if constexpr (D == 3) {
      const double cosine = nominal::dot(w, nominal::direction(d_, c.from));
      return std::atan2(nominal::dot(w, nominal::direction(d_, c.towards)),
                        c.opposite ? -cosine : cosine);
    }
    const Vec x = c.from.is_given() ? nominal::direction(d_, c.from) : Vec{1, 0, 0};
    return std::atan2(x[0] * w[1] - x[1] * w[0], nominal::dot(x, w));
  }

  /// Zero when a value is what rounding leaves of products of this magnitude.
  static double snap(double value, double magnitude) {
    return std::abs(value) <= 16 * eps * magnitude ? 0 : value;
  }
  /// What the components of a direction were subtracted from.
  double scale(const Direction& d) const { return d.is_segment() ? reach_ : 1; }

  static std::array<double, D> components(const Vec& v) {
    std::array<double, D> result;
    std::copy_n(v.begin(), D, result.begin());
    return result;
  }

  std::string text(const Direction& d) const {
    return d.is_segment() ? d_.points[d.from].name + "-" + d_.points[d.to].name
                          : d_.vectors[d.vector].name;
  }

  void sort_by_group() {
    std::vector<int> order(origins_.size());
    std::iota(order.begin(), order.end(), 0);
    std::ranges::stable_sort(order, {}, [&](int c) { return m_.constraints[c].group; });
    std::vector<Constraint> constraints;
    std::vector<Origin> origins;
    for (const int c : order) {
      constraints.push_back(std::move(m_.constraints[c]));
      origins.push_back(origins_[c]);
    }
    m_.constraints = std::move(constraints);
    origins_ = std::move(origins);
  }

  const Description& d_;
  const RigidBodies& rigid_;
  const Structure& structure_;
  const std::vector<Motion>& motions_;
  Mechanism m_;
  std::vector<Origin> origins_;
  double reach_ = 0;  // largest nominal coordinate
  int constant_groups_ = 0;
  std::vector<EntityId> point_, vector_;  // of the description's; -1: not modelled (yet)
  std::vector<int> found_points_, found_vectors_;  // structural group that finds each
  std::vector<Description::Coordinate> measured_;
  std::vector<EntityId> coordinate_;            // of those measured
  std::vector<std::vector<int>> measured_by_;   // by each structural group
  std::set<std::pair<std::array<int, 3>, std::array<int, 3>>> products_;
  std::set<std::array<int, 3>> slides_measured_;
};

}  // namespace

Candidates make_candidates(const Description& d, const RigidBodies& rigid,
                           const Structure& structure, const std::vector<Motion>& motions) {
  return d.dimension == 2 ? Modeller<2>(d, rigid, structure, motions).make()
                          : Modeller<3>(d, rigid, structure, motions).make();
}

}  // namespace desmo
