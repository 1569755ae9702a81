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
  int parent;  ///< -1: the ground
  Joint joint;
  Vec place;  ///< of the joint, in the parent's frame
  Vec axis{}, second_axis{};
  int driver = -1;  ///< of the coordinate of a pin or slider: position in Tree::drivers
};

/// A constraint that closes a loop. Points and directions are in the frames of their bodies; -1:
/// the ground.
struct Constraint {
  enum class Kind {
    rod,             ///< the points have a constant distance
    point_on_line,   ///< the second point stays on the line through the first along `direction`
    point_in_plane,  ///< the second point stays in the plane through the first normal to it
  };
  Kind kind;
  std::array<int, 2> bodies;
  std::array<Vec, 2> points;
  Vec direction{};
  double length = 0;
};

/// A point or a direction that is fixed to a body and asked for.
struct Followed {
  int body;
  bool is_point;
  Vec in_body;
  int components;  ///< 2: x and y only
};

/// A mechanism as Simbody takes it: a tree of joint coordinates, closed by constraints.
struct Tree {
  std::vector<Body> bodies;  ///< parents before their children
  std::vector<Constraint> constraints;
  std::vector<Followed> followed;
  std::vector<std::function<Vec(double)>> drivers;  ///< value, rate and second rate at a time
};

/// The method for velocities and accelerations.
enum class Rates {
  /// The manual's: projectU, then realize(Acceleration), which solves the equations of
  /// motion; the constraints determine the accelerations whatever the masses are.
  realized,
  /// G u = 0 and G u̇ = b with one factorisation of the constraint matrix that Simbody evaluates.
  direct,
};

/// Solves a tree at one instant after the other. Its coordinates, those of the joints, stay inside.
class Solver {
 public:
  virtual ~Solver() = default;

  /// Solves positions, velocities and accelerations at time t [s], starting from Body::estimate,
  /// whatever was solved before. Throws std::exception when Simbody cannot.
  virtual void assemble(double t) = 0;
  /// Solves like assemble(), but starts from q + q̇ h + q̈ h²/2 of the instant solved last.
  virtual void step(double t) = 0;
  /// Returns the instant solved last: the components of Tree::followed in its order [m, 1], their
  /// first and their second derivatives. Valid, and overwritten, until the next is solved.
  virtual const std::array<std::vector<double>, 3>& values() const = 0;
  /// Returns the iterations of projectQ since the last assembly, with its own.
  virtual long iterations() const = 0;
  /// "8 bodies, 12 mobilities, 2 of them prescribed, 10 loop-constraint equations"
  virtual std::string setup() const = 0;
};

std::unique_ptr<Solver> make_solver(const Tree& tree, Rates rates);

/// Returns the version of the library, "3.7.0".
std::string version();

}  // namespace desmo::simbody
