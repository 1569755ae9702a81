#pragma once

// C++17 and nothing else of desmo: Simbody's headers are not C++20, clash with Eigen 3.4 in one
// file and, as Debian builds the library, must be compiled with assertions.

#include <array>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace desmo::simbody {

using Vec = std::array<double, 3>;

enum class Joint {
  pin,        ///< turns about `axis`
  slider,     ///< moves along `axis`
  gimbal,     ///< turns about a point: three angles
  universal,  ///< turns about `axis`, fixed to the parent, and `second_axis`, fixed to the body
};

/// A body and its joint with the body before it in the tree. The body's frame has its origin at the
/// joint and is parallel to the parent's where the joint's coordinates are zero.
struct Body {
  int parent;  ///< index of the body before it; -1: the ground
  Joint joint;
  Vec place;  ///< place of the joint in the parent's frame
  Vec axis{}, second_axis{};
  int driver = -1;  ///< index in Tree::drivers of the driver of a pin or slider; -1: it is free
};

/// A constraint that closes a loop between two bodies; -1: the ground. Points are in the frames of
/// their bodies, `direction` is in that of the first body.
struct Constraint {
  enum class Kind {
    rod,             ///< the points have a constant distance
    point_on_line,   ///< the second point stays on the line through the first along `direction`
    point_in_plane,  ///< the second point stays in the plane through the first normal to
                     ///< `direction`
  };
  Kind kind;
  std::array<int, 2> bodies;
  std::array<Vec, 2> points;
  Vec direction{};
  double length = 0;  ///< length of a rod
};

/// A point or a direction that is fixed to a body and followed: the solver gives the point's
/// position, or the direction's components, in the ground's frame.
struct Followed {
  int body;
  bool is_point;
  Vec in_body;
  int coordinate;  ///< index of the first component in the model's coordinates
  int components;  ///< 3, or 2: x and y only
};

/// A mechanism as Simbody takes it: a tree of joint coordinates, closed by constraints.
struct Tree {
  std::vector<Body> bodies;  ///< parents before their children
  std::vector<Constraint> constraints;
  std::vector<Followed> followed;
  std::vector<std::function<Vec(double)>> drivers;  ///< value, rate and second rate at a time [s]
};

/// The method for velocities and accelerations.
enum class Rates {
  /// The manual's: projectU to 1e-10, then realize(Acceleration), which solves the equations of
  /// motion. The constraints determine the accelerations whatever the masses are; all are 1.
  realized,
  /// G u = 0 and G u̇ = b with one LU of the constraint matrix G that Simbody evaluates.
  direct,
};

/// A solver that steps through the positions of a tree. Both assemble() and step() prescribe the
/// driven coordinates and project the others onto the constraints (projectQ). There the root mean
/// square of the constraint errors is at most 1e-10. Then they solve for velocities and
/// accelerations, and deliver. All of this is timed; making the solver is not. Both throw
/// std::exception when Simbody cannot.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Solves at time t [s] from the nominal position, in which joint coordinates are 0 and nothing
  /// moves, whatever was solved before.
  virtual void assemble(double t) = 0;
  /// Solves at time t [s], starting from q + q̇ h + q̈ h²/2 of the last instant.
  virtual void step(double t) = 0;
  /// Returns the components of all of Tree::followed at the last instant, in their order, then
  /// their first and their second time derivatives.
  virtual const std::array<std::vector<double>, 3>& values() const = 0;
  /// Returns the number of iterations of projectQ from the last assembly on, which is included.
  virtual long iterations() const = 0;
};

/// Makes a solver. Throws std::exception when Simbody refuses the tree, or when it has more or
/// fewer loop equations than mobilities that no driver prescribes.
std::unique_ptr<Solver> make_solver(const Tree& tree, Rates rates);

/// Returns the version of the library, "3.7.0".
std::string version();

}  // namespace desmo::simbody
