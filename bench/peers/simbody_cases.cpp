// The two cases with as few mobilities and loop equations as their mechanisms allow, for what
// Simbody solves costs their third power. What else was tried stands in bench/peers/README.md.

#include "bench/peers/simbody_cases.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "bench/peers/named.h"

namespace desmo::simbody {

namespace {

constexpr int ground = -1;
constexpr Vec y_axis{0, 1, 0}, z_axis{0, 0, 1};

Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double norm(const Vec& a) { return std::hypot(a[0], a[1], a[2]); }

class Builder {
 public:
  Builder(const Scene& scene, const Model& model)
      : scene_(scene), mechanism_(scene.mechanism), model_(model) {}

  CaseTree four_bar();
  CaseTree truck_suspension();

 private:
  int add(const Body& body) {
    result_.tree.bodies.push_back(body);
    return static_cast<int>(result_.tree.bodies.size()) - 1;
  }
  int add_driver() {
    std::vector<std::function<Vec(double)>>& drivers = result_.tree.drivers;
    drivers.push_back([&motion = scene_.motions.at(drivers.size())](double t) -> Vec {
      const MotionSample<double> z = sample(motion, t);
      return {z.position, z.velocity, z.acceleration};
    });
    return static_cast<int>(drivers.size()) - 1;
  }
  void add_rod(int a, const Vec& at_a, int b, const Vec& at_b, double length) {
    result_.tree.constraints.push_back({Constraint::Kind::rod, {a, b}, {at_a, at_b}, {}, length});
  }

  const Vec& nominal(const std::string& point) const {
    return named(mechanism_.points, point).position;
  }
  const Vec& direction(const std::string& vector) const {
    return named(mechanism_.vectors, vector).direction;
  }
  double length(const std::string& link) const {
    return named(mechanism_.bodies, link).length.value();
  }

  /// Asks for an entity that is fixed to a body, unless it never moves or is asked for already.
  void follow(const std::string& name, int body, bool is_point, const Vec& in_body);
  /// Asks for all points and vectors of a body of the description; a body of the tree with its
  /// origin nominally there moves like it, and was nominally parallel to the ground.
  void follow_all(const std::string& described, int body, const Vec& origin);

  void add_axle(const std::string& prefix);
  void add_stabiliser(const std::string& prefix, int axle, const std::string& lever,
                      const std::string& link);
  void add_damper(const std::string& prefix, int axle, const std::string& rod,
                  const std::string& tube);
  void add_wheel(const std::string& centre, int axle, const Vec& axle_origin);

  const Scene& scene_;
  const Mechanism& mechanism_;
  const Model& model_;
  CaseTree result_;
};

void Builder::follow(const std::string& name, int body, bool is_point, const Vec& in_body) {
  const EntityId id = model_.find(name);
  if (model_.rests(id)) return;
  const Entity& entity = model_.entities[id];
  if (std::ranges::find(result_.coordinates, entity.first) != result_.coordinates.end()) return;
  result_.tree.followed.push_back({body, is_point, in_body, entity.size});
  for (int i = 0; i < entity.size; ++i) result_.coordinates.push_back(entity.first + i);
}

void Builder::follow_all(const std::string& described, int body, const Vec& origin) {
  const Mechanism::Body& b = named(mechanism_.bodies, described);
  for (const int p : b.points)
    follow(mechanism_.points[p].name, body, true, mechanism_.points[p].position - origin);
  for (const int v : b.vectors)
    follow(mechanism_.vectors[v].name, body, false, mechanism_.vectors[v].direction);
}

/// Crank and rockers turn on the ground; each coupler is a rod between two of them, one equation
/// and no body: K mobilities beside the driven one, K equations.
CaseTree Builder::four_bar() {
  int before = add({ground, Joint::pin, nominal("crank/A"), z_axis, {}, 0, add_driver()});
  Vec end{length("crank"), 0, 0};
  follow("crank/B", before, true, end);
  const int dyads = static_cast<int>(mechanism_.bodies.size() - 2) / 2;  // without ground, crank
  for (int k = 1; k <= dyads; ++k) {
    const std::string dyad = "dyad" + std::to_string(k) + "/";
    const double estimate = named(mechanism_.coordinates, dyad + "psi").estimate.value();
    const int rocker = add({ground, Joint::pin, nominal(dyad + "D"), z_axis, {}, estimate});
    const Vec rocker_end{length(dyad + "rocker"), 0, 0};
    add_rod(before, end, rocker, rocker_end, length(dyad + "coupler"));
    follow(dyad + "C", rocker, true, rocker_end);
    before = rocker;
    end = rocker_end;
  }
  return std::move(result_);
}

CaseTree Builder::truck_suspension() {
  const int axles = static_cast<int>(scene_.motions.size()) / 2;
  for (int a = 1; a <= axles; ++a) add_axle("axle" + std::to_string(a) + "/");
  return std::move(result_);
}

/// The arm turns on the chassis, the axle on the arm; the lower rods are rods. Three angles, far
/// from where they are singular, need no normalisation as a quaternion does.
void Builder::add_axle(const std::string& prefix) {
  const Vec r = nominal(prefix + "R"), s = nominal(prefix + "S");
  const int arm = add({ground, Joint::pin, r, y_axis});
  const int axle = add({arm, Joint::gimbal, s - r});
  follow_all(prefix + "3", arm, r);
  follow_all(prefix + "2", axle, s);
  add_wheel(prefix + "WL", axle, s);
  add_wheel(prefix + "WR", axle, s);
  for (const char* side : {"4", "5"}) {
    const Vec c = nominal(prefix + "C" + side), g = nominal(prefix + "G" + side);
    add_rod(ground, g, axle, c - s, norm(c - g));
  }
  add_stabiliser(prefix, axle, "6", "8");
  add_stabiliser(prefix, axle, "7", "9");
  add_damper(prefix, axle, "10", "11");
  add_damper(prefix, axle, "12", "13");
}

/// The wheel centre stays in a level plane that moves with a driven slider.
void Builder::add_wheel(const std::string& centre, int axle, const Vec& axle_origin) {
  const int height = add({ground, Joint::slider, {}, z_axis, {}, 0, add_driver()});
  result_.tree.constraints.push_back({Constraint::Kind::point_in_plane,
                                      {height, axle},
                                      {Vec{}, nominal(centre) - axle_origin},
                                      z_axis});
}

/// The lever turns on the axle; the link is a rod.
void Builder::add_stabiliser(const std::string& prefix, int axle, const std::string& lever,
                             const std::string& link) {
  const Vec s = nominal(prefix + "S"), a = nominal(prefix + "A" + lever);
  const Vec b = nominal(prefix + "B" + lever), g = nominal(prefix + "G" + link);
  const int body = add({axle, Joint::pin, a - s, y_axis});
  add_rod(ground, g, body, b - a, norm(b - g));
  follow_all(prefix + lever, body, a);
}

/// One body stands for rod and tube, which turn as one; its line goes through T.
void Builder::add_damper(const std::string& prefix, int axle, const std::string& rod,
                         const std::string& tube) {
  const Vec s = nominal(prefix + "S"), a = nominal(prefix + "A" + rod);
  const Vec t = nominal(prefix + "T" + tube);
  const int body =
      add({axle, Joint::universal, a - s, direction(prefix + "x2"), direction(prefix + "u" + rod)});
  result_.tree.constraints.push_back(
      {Constraint::Kind::point_on_line, {body, ground}, {Vec{}, t}, t - a});
  follow_all(prefix + rod, body, a);
  follow_all(prefix + tube, body, a);
}

}  // namespace

CaseTree case_tree(const Scene& scene, const Model& model) {
  Builder builder(scene, model);
  if (scene.mechanism.name == "four_bar") return builder.four_bar();
  if (scene.mechanism.name == "truck_suspension") return builder.truck_suspension();
  throw std::invalid_argument("simbody: no model of '" + scene.mechanism.name + "'");
}

}  // namespace desmo::simbody
