#include "formulations/modelling/candidates.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace desmo {

namespace {

using nominal::Vec;
using nominal::operator-;
using Direction = Description::Direction;

template <int D>
class EquationWriter {
 public:
  EquationWriter(const Description& d, const RigidBodies& rigid, Coordinates coordinates)
      : d_(d),
        rigid_(rigid),
        c_(std::move(coordinates)),
        m_(c_.mechanism),
        point_(c_.points),
        vector_(c_.vectors),
        declared_(d) {
    for (const Description::Point& p : d.points)
      for (const double x : p.position) reach_ = std::max(reach_, std::abs(x));
  }

  Candidates write() {
    hold_ground_vectors();
    for (std::size_t r = 1; r < rigid_.list.size(); ++r) model_body(rigid_.list[r]);
    for (const Description::Joint& j : d_.joints) model_joint(j);
    for (std::size_t c = 0; c < c_.measured.size(); ++c) model_coordinate(c);
    sort_by_group();
    return {std::move(m_), std::move(origins_)};
  }

 private:
  static constexpr double eps = std::numeric_limits<double>::epsilon();

  void hold_ground_vectors() {
    for (const int v : rigid_.list.front().vectors) {
      if (m_.entities[vector_[v]].fixed) continue;
      const EntityId held = m_.add_fixed(EntityKind::vector, "ground: " + d_.vectors[v].name,
                                         components(d_.vectors[v].direction));
      constrain<Rigid<D, 0>>(Origin::ground, d_.vectors[v].name + " on the ground",
                             {vector_[v], held}, {});
    }
  }

  template <class Kind>
  void constrain(Origin origin, std::string name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<double, Kind::constants>& constants) {
    const GroupId g = last_group({operands.begin(), operands.end()});
    if (g < 0) return;  // nothing in it can move
    m_.constrain<Kind>(g, std::move(name), operands, constants);
    origins_.push_back(origin);
  }

  /// Whether a constant product of two directions is met for the first time; bodies that share
  /// both state it once, unless they contradict each other.
  bool is_new_product(const Direction& a, const Direction& b, double product) {
    const auto key = [](const Direction& d) {
      return d.is_segment() ? std::array{1, std::min(d.from, d.to), std::max(d.from, d.to)}
                            : std::array{0, d.vector, d.vector};
    };
    const auto [it, is_new] = products_.emplace(std::minmax({key(a), key(b)}), product);
    return is_new || std::abs(std::abs(it->second) - std::abs(product)) >
                         1e-12 * std::max(1.0, reach_ * reach_);
  }

  void model_body(const RigidBody& body) {
    const std::string name = d_.bodies[body.bodies.front()].name + ": ";
    const std::vector<Direction>& directions = body.basis.directions;
    for (std::size_t i = 0; i < directions.size(); ++i)
      for (std::size_t j = i; j < directions.size(); ++j)
        keep_product(name, body, directions[i], directions[j]);
    for (const int p : body.points)
      if (!body.basis.has_point(p)) relate_point(name, body, p);
    for (const int v : body.vectors)
      if (follows_from_points(d_, body, v))
        keep_along(name, body, v);
      else if (!body.basis.has_vector(v))
        relate_vector(name, body.basis, v);
  }

  /// A constant product of two directions; vectors come before segments in a basis.
  void keep_product(const std::string& name, const RigidBody& body, const Direction& a,
                    const Direction& b) {
    const Vec u = nominal::direction(d_, body, a), v = nominal::direction(d_, body, b);
    if (!is_new_product(a, b, nominal::dot(u, v))) return;
    if (!a.is_segment() && a.vector == b.vector)
      return constrain<Unit<D>>(Origin::body, name + text(a) + " unit", {vector_[a.vector]}, {});
    if (a.is_segment() && a.to == b.to)
      return constrain<Length<D>>(Origin::body, name + text(a) + " length",
                                  {point_[a.from], point_[a.to]}, {nominal::dot(u, u)});
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
    const double length = nominal::norm(nominal::direction(d_, body, {-1, from, to}));
    constrain<Rigid<D, 1>>(Origin::body,
                           name + d_.vectors[v].name + " along " + text({-1, from, to}),
                           {point_[to], point_[from], vector_[v]}, {length});
  }

  void relate_point(const std::string& name, const RigidBody& body, int p) {
    relate(name + d_.points[p].name + " rigid", body.basis, point_[p],
           nominal::direction(d_, body, {-1, body.basis.origin, p}), reach_, true);
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
    const Eigen::VectorXd c = n == 0 ? Eigen::VectorXd()
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
      if (DeclaredSlides::slides(j) && !declared_.contain(j)) {
        const Vec u = d_.vectors[j.vectors[0]].direction;
        const Vec s = d_.points[j.points[1]].position - d_.points[j.points[0]].position;
        constrain<Offset>(Origin::joint, j.name + ": offset",
                          {vector_[j.vectors[0]], point_[j.points[0]], point_[j.points[1]]},
                          {snap(u[0] * s[1] - u[1] * s[0], reach_)});
      }
    } else if (j.type == Description::JointType::universal) {
      const Direction a{j.vectors[0]}, b{j.vectors[1]};
      const double product =
          snap(nominal::dot(nominal::direction(d_, a), nominal::direction(d_, b)), 1);
      if (is_new_product(a, b, product))
        constrain<Dot<3>>(Origin::joint, j.name + ": " + text(a) + " with " + text(b),
                          {vector_[a.vector], vector_[b.vector]}, {product});
    }
  }

  void model_coordinate(std::size_t index) {
    using enum Description::CoordinateType;
    const Description::Coordinate& c = c_.measured[index];
    const EntityId value = c_.coordinates[index];
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
      if (std::ranges::binary_search(rigid_.of_point[d.to], r))
        return nominal::norm(nominal::direction(d_, rigid_.list[r], d));
    throw std::invalid_argument("coordinate '" + c.name + "': no body carries both points of " +
                                text(d) + "; an angle needs a segment of constant length");
  }

  void require_along(const Description::Coordinate& c) const {
    const Vec s = nominal::direction(d_, c.of), u = d_.vectors[c.vector].direction;
    const double along = nominal::dot(s, u);
    const Vec off = s - Vec{along * u[0], along * u[1], along * u[2]};
    if (nominal::norm(off) > 1e-6 * nominal::size(d_))
      throw std::invalid_argument("coordinate '" + c.name + "': " + text(c.of) + " is not along '" +
                                  d_.vectors[c.vector].name + "' in the nominal position");
  }

  /// The last of the groups that find these entities; -1 when all are fixed.
  GroupId last_group(const std::vector<EntityId>& operands) const {
    GroupId g = -1;
    for (const EntityId e : operands) g = std::max(g, m_.entities.at(e).group);
    return g;
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
  Coordinates c_;
  Mechanism& m_;                                 // c_.mechanism
  const std::vector<EntityId>&point_, &vector_;  // those of c_
  DeclaredSlides declared_;
  std::vector<Origin> origins_;
  double reach_ = 0;  // largest nominal coordinate
  std::map<std::pair<std::array<int, 3>, std::array<int, 3>>, double> products_;
};

}  // namespace

Candidates make_candidates(const Description& d, const RigidBodies& rigid,
                           const Structure& structure, const std::vector<Motion>& motions) {
  Coordinates coordinates = make_coordinates(d, rigid, structure, motions);
  return d.dimension == 2 ? EquationWriter<2>(d, rigid, std::move(coordinates)).write()
                          : EquationWriter<3>(d, rigid, std::move(coordinates)).write();
}

}  // namespace desmo
