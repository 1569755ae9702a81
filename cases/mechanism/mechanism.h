#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "cases/mechanism/motion.h"
#include "cases/numbers/derived.h"

namespace desmo {

/// A mechanism: bodies that carry named points and unit vectors, joints by type and by the entities
/// they join, relative coordinates and drivers. The coordinates q and constraint equations belong
/// to its model (formulations/modelling).
///
/// Plain data; entities refer to each other by index in the lists. Lengths are in metres, or in a
/// free unit when `length_unit` is "1"; angles in radians. In the plane the third component is 0.
/// *Nominal* positions and directions are those of the drawing.
struct Mechanism {
  using Vec = std::array<double, 3>;
  /// A position or direction as the file means it: components with their remainders.
  using ExactVec = std::array<Derived, 3>;

  static Vec rounded(const ExactVec& x) { return {x[0].value, x[1].value, x[2].value}; }
  static ExactVec exact(const Vec& x, const std::array<Remainder, 3>& r) {
    return {Derived(x[0], r[0]), Derived(x[1], r[1]), Derived(x[2], r[2])};
  }

  static constexpr int none = -1;  ///< index that stands for an entity that is not given

  struct Point {
    std::string name;
    Vec position;                          ///< nominal position, rounded
    std::array<Remainder, 3> remainder{};  ///< remainder of each component of the position

    ExactVec exact() const { return Mechanism::exact(position, remainder); }
  };

  struct Vector {
    std::string name;
    Vec direction;  ///< nominal direction, of length 1, each component rounded
    /// Two points of a body that carries the vector, which always points from the first to the
    /// second. It then follows from the points by a linear equation.
    std::optional<std::array<int, 2>> along{};
    std::array<Remainder, 3> remainder{};  ///< remainder of each component of the direction

    ExactVec exact() const { return Mechanism::exact(direction, remainder); }
  };

  /// The shape of a body in a frame of its own. The frame's place is an estimate.
  struct Frame {
    Vec origin, rotation;           ///< nominal place; rotation vector [rad], in the plane along z
    std::vector<ExactVec> points;   ///< positions of Body::points in the frame
    std::vector<ExactVec> vectors;  ///< directions of Body::vectors in the frame, of length 1
  };

  /// A rigid body. Its points and vectors are listed in the order in which modelling prefers them
  /// as basis of the body's coordinates. Several bodies may carry the same point or vector if
  /// joints connect them there.
  struct Body {
    std::string name;
    std::vector<int> points{}, vectors{};
    /// Distance between the two points of a body that has no others; their nominal positions are
    /// then estimates. Without it the nominal distance holds.
    std::optional<Derived> length{};
    /// Shape in the body's own frame; nominal positions and directions are then estimates. Sliding
    /// joints of such a body have no offset from their line or plane, whatever is drawn. The two
    /// vectors of its universal joints are at a right angle.
    std::optional<Frame> own{};
  };

  enum class JointType {
    revolute,            ///< plane: a shared point; space: a shared point and vector, the axis
    prismatic,           ///< a shared vector, the axis; a point of each body, of which one slides
                         ///< along the axis; space: a second shared vector, against rotation
    revolute_on_slider,  ///< plane: a vector and a point of the first body; a point of the second
                         ///< that slides along that line
    cylindrical,         ///< space: a shared vector, the axis; a point on it of each body
    universal,           ///< space: a shared point; for each body a vector, at a constant angle
    spherical,           ///< space: a shared point
    fixed,               ///< the two bodies move as one
    hinge,               ///< space: two shared points, through which the axis goes
    point_on_line,       ///< space: a vector and a point of the first body; a point of the second
                         ///< that slides along that line
    point_on_plane,      ///< space: a vector, the normal, and a point of the first body; a point of
                         ///< the second, which keeps its distance from that plane
    planar,              ///< space: a shared vector, the normal; a point of each body, of which one
                         ///< keeps its distance from the plane through the other
  };

  /// A direction: a vector, or the line from one point to another.
  struct Direction {
    int vector = none;
    int from = none, to = none;  ///< indices of the points of a line
    bool is_line() const { return from != none; }
    bool is_given() const { return vector != none || from != none; }
  };

  struct Joint {
    std::string name;  ///< unique among joints; name_joints() gives one where it is empty
    JointType type;
    std::array<int, 2> bodies;  ///< indices of the first and the second body
    /// Entities as JointType lists them: shared ones, the first body's, then the second's.
    std::vector<int> points, vectors;
    /// Returns the line from the first of the joint's points to the second. It must have two.
    Direction line() const { return {none, points[0], points[1]}; }
  };

  enum class CoordinateType {
    angle,     ///< angle [rad] to direction `of` from direction `from`, by default the x axis. In
               ///< space it counts from −from if `opposite`, and goes to the projection of `of`
               ///< onto the plane of `from` and `towards`
    distance,  ///< distance of two points, ≥ 0 as drawn; changes its sign when they pass each other
    along,     ///< signed distance from one point to another along a vector parallel to their line
    component,  ///< coordinate of a point along an axis of the ground's frame
  };

  /// A relative coordinate, measured or driven.
  struct Coordinate {
    std::string name;
    CoordinateType type;
    Direction of;           ///< angle: the direction that turns; distance, along: the line
    Direction from;         ///< angle: direction where it is 0; not given (plane only): the x axis
    bool opposite = false;  ///< angle in space: it is 0 at −from, not at from
    Direction towards;      ///< angle in space: direction where it is π/2
    int vector = none;      ///< along: index in `vectors`
    int point = none;       ///< component: index in `points`
    int axis = 0;           ///< component: 0, 1, 2 for x, y, z
    std::optional<double> estimate;  ///< initial estimate; none: its value in the nominal position
    bool driven = false;             ///< a motion is prescribed (Scene::motions)

    bool is_angle() const { return type == CoordinateType::angle; }
  };

  /// A relation between coordinates. Angles count with their whole turns [rad].
  /// - linear, such as a gear: Σ factor · coordinate keeps the value that it has in the nominal
  ///   position
  /// - by a table f, such as a cam, with two terms: first coordinate = from + f(x) / first factor,
  ///   where x = second factor · second coordinate
  struct Coupling {
    struct Term {
      int coordinate;
      Derived factor;
    };
    /// A cubic spline f through `values` at ascending arguments. Periodic and indexing ones repeat
    /// on both sides; indexing ones rise by last value − first value with each repetition.
    struct Table {
      std::vector<double> arguments, values;
      SplineEnds ends = SplineEnds::natural;
      /// Constant term [m, free unit or rad]; none: such that the nominal position fulfils the
      /// coupling.
      std::optional<Derived> from = Derived();

      bool repeats() const { return ends == SplineEnds::periodic || ends == SplineEnds::indexing; }
    };
    static constexpr int min_terms = 2, max_terms = 4;

    std::string name;
    std::vector<Term> terms;
    std::optional<Table> table{};
  };

  std::string name;
  std::string title;              ///< description in one line; may be empty
  int dimension = 3;              ///< 2 or 3
  std::string length_unit = "m";  ///< "m", or "1": a free unit
  std::vector<Point> points;
  std::vector<Vector> vectors;
  std::vector<Body> bodies;  ///< all bodies; the first is the ground
  std::vector<Joint> joints;
  std::vector<Coordinate> coordinates;
  std::vector<Coupling> couplings;
};

/// Names each joint that has no name: type/first body/second body, such as `revolute/crank/rod`.
/// Adds the least free number from 2 on to a name that is taken: `revolute/crank/rod/2`.
/// Readers of files and MechanismBuilder::release() call this function.
void name_joints(Mechanism& mechanism);

/// Checks a mechanism. Throws MechanismError, a std::invalid_argument, naming the offender and the
/// remedy, unless:
/// - dimension is 2 or 3, and all numbers are finite
/// - names are not empty, and unique among bodies, among joints, among couplings, and among points,
///   vectors and coordinates together
/// - there is a first body, the ground; indices are in range, and nothing is listed twice
/// - in the plane third components are 0; vectors have length 1, with an error of at most 1e-9
/// - each joint has two bodies, which carry the entities that its type and the dimension require
/// - the vectors of a spatial prismatic joint are not parallel, and the points of a hinge differ
/// - bodies that carry the same entity are connected, by joints that have it in common or by fixed
///   joints
/// - if bodies carry an `along` vector, one of them carries both of its points
/// - coordinates refer to different entities, carried by bodies; an angle in space has vectors
///   `from` and `towards` at a right angle (|cosine| ≤ 1e-6), and is not perpendicular to both
/// - couplings relate two to four different coordinates, not all of them driven, and no factor
///   is 0; a coupling by a table relates two, and make_spline() takes its numbers
/// - no line used as a direction has zero length
/// - the points of a moving body without vectors do not all coincide, where it has two or more
/// - a given length is positive and its body has exactly two points, which do not coincide
/// - a body with a frame of its own is not the ground, and has no length and no fixed joint; the
///   frame has each of the body's points and vectors
void validate(const Mechanism& mechanism);

}  // namespace desmo
