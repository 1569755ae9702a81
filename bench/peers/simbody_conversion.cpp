#include "bench/peers/simbody_conversion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/names.h"

namespace desmo::simbody {

namespace {

constexpr int ground = -1;

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double norm(const Vec& a) { return std::hypot(a[0], a[1], a[2]); }

/// A tree under construction. Bodies, points and vectors have the mechanism's names; the tree's
/// bodies are numbered as they come.
class Builder {
 public:
  Builder(const Scene& scene, const Model& model) : mechanism_(scene.mechanism), model_(model) {}

  Vec position(const std::string& point) const {
    return entry_named(point, mechanism_.points, "point").position;
  }
  Vec direction(const std::string& vector) const {
    return entry_named(vector, mechanism_.vectors, "vector").direction;
  }

  /// Hangs a body on another by a joint at a point of both. Follows its points and vectors. Returns
  /// the body's index in the tree.
  int hang(const std::string& name, int parent, Joint joint, const std::string& at,
           const Vec& axis = {0, 0, 1}, const Vec& second_axis = {}) {
    const Mechanism::Body& body = body_named(name);
    const int number = static_cast<int>(tree.bodies.size());
    tree.bodies.push_back({parent, joint, in_frame(parent, at), axis, second_axis});
    frames_.push_back({position(at), body.length});
    for (const int p : body.points) {
      const std::string& point = mechanism_.points[p].name;
      follow(point, number, true, in_frame(number, point));
    }
    follow_vectors(name, number);
    return number;
  }

  /// Follows the vectors of a body of the mechanism that turns like body `body` of the tree.
  void follow_vectors(const std::string& name, int body) {
    for (const int v : body_named(name).vectors)
      follow(mechanism_.vectors[v].name, body, false, mechanism_.vectors[v].direction);
  }

  /// Adds a constraint that keeps a point of each body at the distance of a rod's length. The tree
  /// has no body for the rod: its vectors are not followed.
  void join(const std::string& rod, int first, const std::string& begin, int last,
            const std::string& end) {
    const double length =
        body_named(rod).length.value_or(Derived(norm(position(end) - position(begin)))).value;
    tree.constraints.push_back({Constraint::Kind::rod,
                                {first, last},
                                {in_frame(first, begin), in_frame(last, end)},
                                {},
                                length});
  }

  /// Adds a driver. zero: its value where the joint's coordinate is 0. Returns its index in
  /// Tree::drivers.
  int drive(const Motion& motion, double zero = 0) {
    tree.drivers.push_back([&motion, zero](double t) -> Vec {
      const MotionSample<double> z = sample(motion, t);
      return {z.position - zero, z.velocity, z.acceleration};
    });
    return static_cast<int>(tree.drivers.size()) - 1;
  }

  /// Returns a point in the frame of a body, which nominally is parallel to the ground's.
  Vec in_frame(int body, const std::string& point) const {
    if (body == ground) return position(point);
    const auto& [origin, length] = frames_[body];
    Vec v = position(point) - origin;
    if (length && norm(v) > 0) {
      const double scale = length->value / norm(v);  // nominal positions are but estimates
      for (double& x : v) x *= scale;
    }
    return v;
  }

  Tree tree;

 private:
  struct Frame {
    Vec origin;
    std::optional<Derived> length;  // exact length of a link that begins at `origin`; else nothing
  };

  const Mechanism::Body& body_named(const std::string& name) const {
    return entry_named(name, mechanism_.bodies, "body");
  }

  /// Follows an entity that is fixed to a body, unless it is at rest or followed already.
  void follow(const std::string& name, int body, bool is_point, const Vec& in_body) {
    const EntityId id = model_.find(name);
    const Entity& entity = model_.entities[id];
    if (model_.is_at_rest(id) ||
        std::ranges::count(tree.followed, entity.first, &Followed::coordinate))
      return;
    tree.followed.push_back({body, is_point, in_body, entity.first, entity.size});
  }

  const Mechanism& mechanism_;
  const Model& model_;
  std::vector<Frame> frames_;  // one for each body of the tree
};

Tree four_bar(const Scene& scene, const Model& model) {
  Builder b(scene, model);
  const int dyads = static_cast<int>(scene.mechanism.bodies.size() - 2) / 2;
  const auto dyad = [](int k) { return "dyad" + std::to_string(k) + "/"; };
  std::vector<int> turning(dyads + 1);  // indices in the tree of the crank and of the rockers
  const auto join = [&](int k) {
    b.join(dyad(k) + "coupler", turning[k - 1], k == 1 ? "crank/B" : dyad(k - 1) + "C", turning[k],
           dyad(k) + "C");
  };
  // This order is that of earlier records: the crank comes late, and with it the first coupler.
  for (int k = 1; k <= dyads; ++k) {
    if (k == dyads) turning[0] = b.hang("crank", ground, Joint::pin, "crank/A");
    turning[k] = b.hang(dyad(k) + "rocker", ground, Joint::pin, dyad(k) + "D");
    if (k > 1 && k < dyads) join(k);
  }
  join(1);
  if (dyads > 1) join(dyads);
  const Vec line = b.position("crank/B") - b.position("crank/A");
  b.tree.bodies[turning[0]].driver = b.drive(scene.motions.at(0), std::atan2(line[1], line[0]));
  return std::move(b.tree);
}

Tree truck(const Scene& scene, const Model& model) {
  Builder b(scene, model);
  const Vec z{0, 0, 1}, y = b.direction("y1");
  const int axles = static_cast<int>(scene.motions.size()) / 2;
  const auto prefix = [](std::size_t a) { return "axle" + std::to_string(a + 1) + "/"; };
  for (int a = 0; a < axles; ++a) b.hang(prefix(a) + "3", ground, Joint::pin, prefix(a) + "R", y);
  std::vector<int> rigid;
  for (int arm = 0; arm < axles; ++arm) {
    const std::string p = prefix(arm);
    const int axle = rigid.emplace_back(b.hang(p + "2", arm, Joint::gimbal, p + "S"));
    b.join(p + "4", axle, p + "C4", ground, p + "G4");
    b.join(p + "5", axle, p + "C5", ground, p + "G5");
    for (const auto& [rod, tube] : {std::pair{"10", "11"}, {"12", "13"}}) {
      const std::string from = p + "A" + rod, to = p + "T" + tube;
      const int damper = b.hang(p + rod, axle, Joint::universal, from, b.direction(p + "x2"),
                                b.direction(p + "u" + rod));
      b.follow_vectors(p + tube, damper);
      b.tree.constraints.push_back({Constraint::Kind::point_on_line,
                                    {damper, ground},
                                    {Vec{}, b.position(to)},
                                    b.position(to) - b.position(from)});
    }
    for (const auto& [lever, link] : {std::pair{"6", "8"}, {"7", "9"}}) {
      const int turning =
          b.hang(p + lever, axle, Joint::pin, p + "A" + lever, b.direction(p + "y2"));
      b.join(p + link, turning, p + "B" + lever, ground, p + "G" + link);
    }
  }
  for (std::size_t i = 0; i < scene.motions.size(); ++i) {
    const int axle = rigid[i / 2], slider = static_cast<int>(b.tree.bodies.size());
    const std::string wheel = prefix(i / 2) + (i % 2 == 0 ? "WL" : "WR");
    b.tree.bodies.push_back({ground, Joint::slider, {}, z, {}, b.drive(scene.motions[i])});
    b.tree.constraints.push_back(
        {Constraint::Kind::point_in_plane, {slider, axle}, {Vec{}, b.in_frame(axle, wheel)}, z});
  }
  return std::move(b.tree);
}

}  // namespace

Tree convert(const Scene& scene, const Model& model) {
  if (scene.mechanism.name == "four_bar") return four_bar(scene, model);
  if (scene.mechanism.name == "truck_suspension") return truck(scene, model);
  throw std::invalid_argument("simbody: no model of '" + scene.mechanism.name + "'");
}

}  // namespace desmo::simbody
