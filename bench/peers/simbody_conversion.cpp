#include "bench/peers/simbody_conversion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace desmo::simbody {

namespace {

using enum Mechanism::JointType;

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double norm(const Vec& a) { return std::hypot(a[0], a[1], a[2]); }

int other(const Mechanism::Joint& joint, int body) {
  return joint.bodies[joint.bodies[0] == body ? 1 : 0];
}

/// A conversion under way: run() makes the tree, once.
class Conversion {
 public:
  Conversion(const Scene& scene, const Model& model) : d_(scene.mechanism), model_(model) {
    placed_[0].in_tree = ground;
    for (const Mechanism::Joint& joint : d_.joints)
      for (const int body : joint.bodies) placed_[body].joints.push_back(&joint);
  }

  Tree run(const std::vector<Motion>& motions) {
    if (!d_.couplings.empty())
      throw std::invalid_argument("simbody: '" + d_.name + "' has couplings");
    for (const Mechanism::Body& body : d_.bodies)
      if (body.own)
        throw std::invalid_argument("simbody: '" + body.name + "' has a frame, and is not drawn");
    find_links();
    do close_links();
    while (place_next());
    auto motion = motions.begin();
    for (const Mechanism::Coordinate& c : d_.coordinates)
      if (c.driven) drive(c, *motion++);
    if (used_ >= d_.joints.size()) return std::move(tree_);
    throw std::invalid_argument("simbody: '" + d_.name + "' has loops that no rod or strut closes");
  }

 private:
  static constexpr int ground = -1, unplaced = -2;

  enum class Role { body, possible_rod, in_link };

  struct Placed {
    std::vector<const Mechanism::Joint*> joints;
    Role role = Role::body;
    int in_tree = unplaced;  // position
    int origin = -1;         // point
  };

  /// A rod or a strut: one or two bodies. The ends join the first and the last of them to others.
  struct Link {
    std::vector<int> bodies;
    std::array<const Mechanism::Joint*, 2> ends;
    int neighbour(int k) const { return other(*ends[k], k == 0 ? bodies.front() : bodies.back()); }
    int point(int k) const { return ends[k]->points[0]; }
  };

  bool is_planar() const { return d_.dimension == 2; }
  const Vec& position(int point) const { return d_.points[point].position; }

  int mobilities(const Mechanism::Joint& joint) const {
    if (joint.type == revolute) return 1;
    if (!is_planar() && joint.type == universal) return 2;
    if (!is_planar() && joint.type == spherical) return 3;
    throw std::invalid_argument("simbody: no counterpart of joint '" + joint.name + "'");
  }

  /// Returns a point in the frame of a body, which nominally is parallel to the ground's.
  Vec offset(int body, int point) const {
    if (body == 0) return position(point);
    Vec v = position(point) - position(placed_[body].origin);
    if (const auto& length = d_.bodies[body].length; length && norm(v) > 0) {
      const double scale = *length / norm(v);  // nominal positions are but estimates
      for (double& x : v) x *= scale;
    }
    return v;
  }

  void add_link(std::vector<int> bodies, const Mechanism::Joint* a, const Mechanism::Joint* b) {
    for (const Mechanism::Joint* end : {a, b})
      if (end->type != (is_planar() ? revolute : universal) && end->type != spherical) return;
    // In space one end lets the link spin, and only one.
    if (a->points == b->points || mobilities(*a) + mobilities(*b) != (is_planar() ? 2 : 5)) return;
    if (mobilities(*a) > mobilities(*b)) {
      std::swap(a, b);
      std::ranges::reverse(bodies);
    }
    for (const int body : bodies)
      placed_[body].role = bodies.size() == 1 ? Role::possible_rod : Role::in_link;
    links_.push_back({std::move(bodies), {a, b}});
  }

  void find_links() {
    const auto joints = [&](int body) -> auto& { return placed_[body].joints; };
    for (int body = 1; body < static_cast<int>(d_.bodies.size()); ++body)
      if (joints(body).size() == 2 && d_.bodies[body].points.size() == 2)
        add_link({body}, joints(body)[0], joints(body)[1]);
    for (const Mechanism::Joint& slide : d_.joints) {
      const auto [a, b] = slide.bodies;
      if (is_planar() || slide.type != prismatic || a == 0 || b == 0) continue;
      if (joints(a).size() != 2 || joints(b).size() != 2) continue;
      add_link({a, b}, joints(a)[joints(a)[0] == &slide], joints(b)[joints(b)[0] == &slide]);
    }
  }

  /// Hangs a body on the other body of a joint.
  void place(const Mechanism::Joint& joint, int body) {
    const int parent = other(joint, body), point = joint.points[0];
    Body b{placed_[parent].in_tree, Joint::pin, offset(parent, point), {0, 0, 1}};
    const int side = joint.bodies[0] == parent ? 0 : 1;
    const auto axis = [&](int k) { return d_.vectors[joint.vectors[k]].direction; };
    if (joint.type == spherical) b.joint = Joint::gimbal;
    if (joint.type == revolute && !is_planar()) b.axis = axis(0);
    if (joint.type == universal) {
      b.joint = Joint::universal;
      b.axis = axis(side);
      b.second_axis = axis(1 - side);
    }
    placed_[body].in_tree = static_cast<int>(tree_.bodies.size());
    placed_[body].origin = point;
    tree_.bodies.push_back(b);
    order_.push_back(body);
    ++used_;
    for (const int p : d_.bodies[body].points)
      follow(d_.points[p].name, body, true, offset(body, p));
    follow_vectors(body, body);
  }

  /// Places the body that needs the fewest mobilities, nearest to the ground; possible rods last.
  /// Returns false when none is left.
  bool place_next() {
    const Mechanism::Joint* best = nullptr;
    int best_body = 0;
    std::pair<bool, int> least{};
    for (const int from : order_)
      for (const Mechanism::Joint* joint : placed_[from].joints) {
        const int body = other(*joint, from);
        const auto& [joints, role, in_tree, origin] = placed_[body];
        if (in_tree != unplaced || role == Role::in_link) continue;
        const std::pair cost{role == Role::possible_rod, mobilities(*joint)};
        if (best && cost >= least) continue;
        best = joint, best_body = body, least = cost;
      }
    if (best) place(*best, best_body);
    return best;
  }

  /// Closes the links between bodies of the tree, which a possible rod may have become itself.
  void close_links() {
    std::erase_if(links_, [&](const Link& link) {
      if (placed_[link.bodies[0]].in_tree != unplaced) return true;
      for (const int k : {0, 1})
        if (placed_[link.neighbour(k)].in_tree == unplaced) return false;
      close(link);
      return true;
    });
  }

  void close(const Link& link) {
    const Vec line = position(link.point(1)) - position(link.point(0));
    const int first = link.neighbour(0), last = placed_[link.neighbour(1)].in_tree;
    const Vec end = offset(link.neighbour(1), link.point(1));
    used_ += 2;
    if (link.bodies.size() == 1) {
      placed_[link.bodies[0]].role = Role::in_link;
      const double length = d_.bodies[link.bodies[0]].length.value_or(norm(line));
      const Vec begin = offset(first, link.point(0));
      tree_.constraints.push_back(
          {Constraint::Kind::rod, {placed_[first].in_tree, last}, {begin, end}, {}, length});
    } else {
      place(*link.ends[0], link.bodies[0]);  // stands for both, which turn as one
      follow_vectors(link.bodies[1], link.bodies[0]);
      const int slider = placed_[link.bodies[0]].in_tree;
      tree_.constraints.push_back(
          {Constraint::Kind::point_on_line, {slider, last}, {Vec{}, end}, line});
    }
  }

  /// Prescribes the angle of a pin on the ground, which counts from its nominal position, or a
  /// slider: a point then stays in a plane that moves with it.
  void drive(const Mechanism::Coordinate& c, const Motion& motion) {
    const bool is_component = c.type == Mechanism::CoordinateType::component;
    const auto body = std::ranges::find_if(order_, [&](int b) {
      if (b == 0) return false;
      if (is_component) return std::ranges::count(d_.bodies[b].points, c.point) > 0;
      return placed_[b].origin == c.of.from && tree_.bodies[placed_[b].in_tree].parent == ground;
    });
    const bool is_pin = is_planar() && c.type == Mechanism::CoordinateType::angle &&
                        c.of.is_line() && !c.from.is_given() && !c.opposite;
    if (body == order_.end() || !(is_component || is_pin))
      throw std::invalid_argument("simbody: '" + c.name + "' cannot be driven");
    const int driver = static_cast<int>(tree_.drivers.size()), in_tree = placed_[*body].in_tree;
    double zero = 0;
    if (is_pin) {
      const Vec line = position(c.of.to) - position(c.of.from);
      zero = std::atan2(line[1], line[0]);
      tree_.bodies[in_tree].driver = driver;
    } else {
      Vec axis{};
      axis[c.axis] = 1;
      const int slider = static_cast<int>(tree_.bodies.size());
      tree_.bodies.push_back({ground, Joint::slider, {}, axis, {}, driver});
      const Vec point = offset(*body, c.point);
      tree_.constraints.push_back(
          {Constraint::Kind::point_in_plane, {slider, in_tree}, {Vec{}, point}, axis});
    }
    tree_.drivers.push_back([&motion, zero](double t) -> Vec {
      const MotionSample<double> z = sample(motion, t);
      return {z.position - zero, z.velocity, z.acceleration};
    });
  }

  /// Asks for an entity that is fixed to a body, unless it rests or is asked for already.
  void follow(const std::string& name, int body, bool is_point, const Vec& in_body) {
    const EntityId id = model_.find(name);
    const Entity& entity = model_.entities[id];
    if (model_.is_at_rest(id) ||
        std::ranges::count(tree_.followed, entity.first, &Followed::coordinate))
      return;
    tree_.followed.push_back({placed_[body].in_tree, is_point, in_body, entity.first, entity.size});
  }

  void follow_vectors(int body, int moving_like) {
    for (const int v : d_.bodies[body].vectors)
      follow(d_.vectors[v].name, moving_like, false, d_.vectors[v].direction);
  }

  const Mechanism& d_;
  const Model& model_;
  Tree tree_;
  std::vector<Placed> placed_ = std::vector<Placed>(d_.bodies.size());  // of each body
  std::vector<Link> links_;                                             // not closed yet
  std::vector<int> order_{0};  // bodies of the tree as they were placed
  std::size_t used_ = 0;       // joints
};

}  // namespace

Tree convert(const Scene& scene, const Model& model) {
  return Conversion(scene, model).run(scene.motions);
}

}  // namespace desmo::simbody
