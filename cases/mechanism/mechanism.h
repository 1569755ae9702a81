#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace desmo {

/// A mechanism: bodies that carry named points and unit vectors, joints
/// by type and by the entities they join, relative coordinates and drivers. Coordinates q and
/// constraint equations are not in it; they are those of its model (formulations/modelling).
///
/// Plain data; entities refer to each other by position in the lists. Lengths in SI (metres, or a
/// free unit when `length_unit` is "1"), angles in radians; in the plane the third component is 0.
struct Mechanism {
  using Vec = std::array<double, 3>;

  struct Point {
    std::string name;
    Vec position;  ///< nominal
  };

  struct Vector {
    std::string name;
    Vec direction;  ///< nominal, of length 1
    /// The body's two points from the first of which to the second it points, always. Such a
    /// vector follows from its points by a linear equation.
    std::optional<std::array<int, 2>> along;
  };

  /// A rigid body. What it carries is listed in the order in which it is preferred as basis of the
  /// body's coordinates. The same point or vector may be carried by several bodies when joints
  /// join them there.
  struct Body {
    std::string name;
    std::vector<int> points, vectors;
    /// Distance of the two points of a body that has no others, when the nominal positions are
    /// but an estimate; otherwise it is the nominal one.
    std::optional<double> length;
  };

  enum class JointType {
    revolute,            ///< plane: a shared point; space: a shared point and vector
    prismatic,           ///< a shared vector, the axis (space: and a second, shared, so that
                         ///< it cannot turn); a point on it of each body
    revolute_on_slider,  ///< plane: a vector and a point of the first body; a point of the
                         ///< second that slides along that line
    cylindrical,         ///< space: a shared vector, the axis; a point on it of each body
    universal,           ///< space: a shared point; a vector of each body at a constant angle
    spherical,           ///< space: a shared point
    fixed,               ///< the two bodies move as one
  };

  struct Joint {
    std::string name;  ///< for messages; unique
    JointType type;
    std::array<int, 2> bodies;
    std::vector<int> points, vectors;  ///< that of the first body before that of the second
  };

  /// A direction: a vector, or the segment between two points.
  struct Direction {
    int vector = -1;
    int from = -1, to = -1;
    bool is_segment() const { return from >= 0; }
    bool is_given() const { return vector >= 0 || from >= 0; }
  };

  enum class CoordinateType {
    angle,      ///< of `of` from `from`; in space in the plane of `from` and `towards`
    distance,   ///< of two points, positive
    along,      ///< from one point to another along a vector that points that way, or opposite
    component,  ///< of a point along an axis of the ground's frame
  };

  /// A relative coordinate: measured, or driven.
  struct Coordinate {
    std::string name;
    CoordinateType type;
    Direction of;                    ///< angle: what turns; distance, along: the segment
    Direction from;                  ///< angle: where it is 0; not given (plane only): the x axis
    bool opposite = false;           ///< angle: it is 0 at −from instead
    Direction towards;               ///< angle in space: where it is π/2
    int vector = -1;                 ///< along
    int point = -1;                  ///< component
    int axis = 0;                    ///< component: 0, 1, 2 for x, y, z
    std::optional<double> estimate;  ///< initial; otherwise measured in the nominal position
    bool driven = false;
  };

  std::string name;
  std::string title;              ///< one line about it, may be empty
  int dimension = 3;              ///< 2 or 3
  std::string length_unit = "m";  ///< "m", or "1": any one unit
  std::vector<Point> points;
  std::vector<Vector> vectors;
  std::vector<Body> bodies;  ///< the first is the ground
  std::vector<Joint> joints;
  std::vector<Coordinate> coordinates;
};

/// Throws std::invalid_argument, naming the offender and the remedy, unless: dimension is 2 or 3;
/// names are not empty, and unique among bodies, among joints, and among points, vectors and
/// coordinates together; indices are in range and nothing is listed twice; numbers are finite,
/// third components 0 in the plane, vectors of length 1; joints have the entities that their type
/// and the dimension ask for, carried by the bodies they name, which are two; the vectors of a
/// spatial prismatic joint are not parallel; an entity carried by several bodies is shared by
/// joints between them all; an `along` vector has its points on a body that carries it; coordinates
/// are of entities that bodies carry, different ones, and an angle in space has `from` and
/// `towards`, vectors at a right angle; no segment that is used as a direction has zero length, and
/// the points of a body that carries nothing else do not all coincide; a given length is positive
/// and of a body with exactly two points.
void validate(const Mechanism& mechanism);

}  // namespace desmo
