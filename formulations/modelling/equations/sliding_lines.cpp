#include "formulations/modelling/equations/sliding_lines.h"

#include <algorithm>
#include <set>
#include <string>
#include <utility>

#include "cases/mechanism/joint_forms.h"
#include "formulations/modelling/bodies/drawing.h"
#include "formulations/modelling/coordinates/coordinates.h"
#include "formulations/modelling/equations/equation_writer.h"

namespace desmo {

namespace {

using Exact = Mechanism::ExactVec;

/// A maker of points on the lines of spatial sliding joints, for joints that are drawn off them.
class LineMaker {
 public:
  LineMaker(const Mechanism& mechanism, const RigidBodies& rigid)
      : mechanism_(mechanism), rigid_(rigid), names_(names_in(mechanism)) {}

  std::optional<Mechanism> make() {
    const double reach = reach_of(mechanism_), max_off = max_off_line * nominal::extent(mechanism_);
    const std::size_t points = mechanism_.points.size();
    for (Mechanism::Joint& j : mechanism_.joints) {
      if (!slides(j.type) || rigid_.of_body[j.bodies[0]] == rigid_.of_body[j.bodies[1]]) continue;
      const double off = drawn_off(mechanism_, rigid_, reach, j.line(), j.vectors[0]);
      if (off == 0 || off > max_off) continue;
      for (const int end : {0, 1})
        if (is_turn_known(j.bodies[end])) {
          put_on_line(j, end);
          break;
        }
    }
    return mechanism_.points.size() > points ? std::optional(std::move(mechanism_)) : std::nullopt;
  }

 private:
  /// Returns whether a body's drawing tells its orientation.
  bool is_turn_known(int body) const {
    const RigidBody& rigid = rigid_.list[rigid_.of_body[body]];
    return rigid.bodies.front() == 0 || (rigid.basis.directions.size() > 1 && !rigid.has_shape());
  }

  /// Replaces a point of a joint by a new one of the same body: the nearest point on the line
  /// through the other point.
  void put_on_line(Mechanism::Joint& j, int end) {
    const Exact off = across(Drawing<Derived>{mechanism_}.direction(j.line()),
                             Drawing<Derived>{mechanism_}.vector(j.vectors[0]));
    const int old = j.points[end], added = static_cast<int>(mechanism_.points.size());
    Mechanism::Point point = mechanism_.points[old];
    Exact foot = point.exact();
    for (int i = 0; i < 3; ++i) foot[i] = end == 0 ? foot[i] + off[i] : foot[i] - off[i];
    set_exact(point.position, point.remainder, foot);
    point.name = add_name(names_, j.name + "/foot");
    mechanism_.points.push_back(point);
    mechanism_.bodies[j.bodies[end]].points.push_back(added);
    complete_basis(j.bodies[end], j.name);
    for (Mechanism::Coordinate& c : mechanism_.coordinates)
      if (is_distance_of(j, c)) (c.of.from == old ? c.of.from : c.of.to) = added;
    j.points[end] = added;
  }

  /// Adds a normal to a body with two directions, since its new point may be off their plane.
  void complete_basis(int body, const std::string& joint) {
    const int r = rigid_.of_body[body];
    const auto& directions = rigid_.list[r].basis.directions;
    if (r == 0 || directions.size() != 2) return;
    const BodyDrawing<Derived> drawing{mechanism_};
    const Exact normal = unit_vector(cross(drawing.direction(rigid_.list[r], directions[0]),
                                           drawing.direction(rigid_.list[r], directions[1])));
    Mechanism::Vector vector;
    vector.name = add_name(names_, joint + "/normal");
    set_exact(vector.direction, vector.remainder, normal);
    mechanism_.bodies[body].vectors.push_back(static_cast<int>(mechanism_.vectors.size()));
    mechanism_.vectors.push_back(vector);
  }

  Mechanism mechanism_;
  const RigidBodies& rigid_;
  std::set<std::string> names_;
};

}  // namespace

double drawn_off(const Mechanism& mechanism, const RigidBodies& rigid, double reach,
                 const Mechanism::Direction& line, int vector) {
  for (const auto& carriers :
       {rigid.of_point[line.from], rigid.of_point[line.to], rigid.of_vector[vector]})
    for (const int r : carriers)
      if (mechanism.bodies[rigid.list[r].bodies.front()].own) return 0;
  const Drawing<double> drawing{mechanism};
  const double off = nominal::norm(cross(drawing.vector(vector), drawing.direction(line)));
  return is_rounding(off, reach) ? 0 : off;
}

std::optional<Mechanism> with_lines_as_drawn(const Mechanism& mechanism, const RigidBodies& rigid) {
  return mechanism.dimension == 3 ? LineMaker(mechanism, rigid).make() : std::nullopt;
}

}  // namespace desmo
