#pragma once

#include <array>
#include <limits>
#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/modelling/bodies/drawing.h"
#include "formulations/modelling/equations/candidates.h"
#include "formulations/modelling/frames/frames.h"

namespace desmo {

/// A writer of candidate equations: adds them to the model of the coordinates.
class EquationWriter {
 public:
  /// Takes over the coordinates. mechanism, rigid and framed must outlive the writer. framed: null
  /// where bodies have no frames.
  EquationWriter(const Mechanism& mechanism, const RigidBodies& rigid, Coordinates coordinates,
                 const FramedMechanism* framed);

  const Mechanism& mechanism;
  const RigidBodies& rigid;
  const FramedMechanism* const framed;
  const double reach;  ///< largest absolute nominal coordinate of a point [unit of length]

  EntityId point(int p) const { return coordinates_.points[p]; }
  EntityId vector(int v) const { return coordinates_.vectors[v]; }
  /// Returns the coordinates; their model contains the equations written so far.
  const Coordinates& coordinates() const { return coordinates_; }

  EntityId add_fixed_vector(std::string name, const Mechanism::Vector& vector);

  /// Adds an internal entity, such as a variable of a joint, to the group of a rigid body. Adds
  /// apostrophes to its name while another entity has the same.
  EntityId add_variable(EntityKind kind, std::string name, std::span<const double> start, int body);

  /// Begins the equations of a rigid body, or of a joint between two. The later of their groups
  /// gets equations between constants that do not hold.
  void begin(int body, int other = 0);

  /// Adds an equation to the last group that solves for one of its operands. An equation between
  /// fixed operands is not added when it holds to rounding. Otherwise it is added to the group that
  /// begin() set, and left out.
  /// - kind: position among the kinds of constraints
  /// - derives: the operand that it derives unless coordinates are natural; no_position: none
  void constrain(EquationSource source, std::string name, int kind,
                 std::span<const EntityId> operands, std::span<const Derived> dimensions,
                 int derives = no_position);
  template <class Kind>
  void constrain(EquationSource source, std::string name,
                 const std::array<EntityId, Kind::operand_sizes.size()>& operands,
                 const std::array<Derived, Kind::constants>& dimensions) {
    constrain(source, std::move(name), kind_index<Kind>(), operands, dimensions);
  }
  /// Adds an equation that derives an operand.
  template <class Kind>
  void derive(EquationSource source, std::string name,
              const std::array<EntityId, Kind::operand_sizes.size()>& operands,
              const std::array<Derived, Kind::constants>& dimensions, int operand = 0) {
    constrain(source, std::move(name), kind_index<Kind>(), operands, dimensions, operand);
  }

  /// Records the scalar product of two directions unless one is recorded. Returns whether it needs
  /// an equation: false when it equals the recorded one, to rounding. Products of two fixed
  /// directions are not recorded and need one. magnitude: that of the terms of which the product is
  /// a sum, such as reach times the length of a line; the product is known to max_rounding of it
  bool note_product(const Mechanism::Direction& a, const Mechanism::Direction& b, double product,
                    double magnitude);

  /// Returns the text of a direction in equation names: "v" or "P-Q".
  std::string text(const Mechanism::Direction& direction) const;

  /// Returns the model with all candidates in group order; leaves the writer empty.
  Model release();

 private:
  /// Returns whether a vector, or both points of a line, are fixed entities.
  bool rests(const Mechanism::Direction& direction) const;

  using Key = std::array<int, 3>;
  Coordinates coordinates_;
  double farthest_;              // largest reach: nominal, or in a body's own frame
  GroupId group_ = no_position;  // group of equations between constants
  struct Product {
    double value, magnitude;
  };
  std::map<std::pair<Key, Key>, Product> products_;
};

/// Returns the largest absolute nominal coordinate of a point [unit of length].
double reach_of(const Mechanism& mechanism);
/// Returns the largest absolute coordinate of a body's points in its own frame (Body::own); `reach`
/// when it has none.
double reach_of(const Mechanism& mechanism, const RigidBody& body, double reach);

/// Largest rounding of a difference of a file's numbers, relative to their magnitude: 16 ε.
inline constexpr double max_rounding = 16 * std::numeric_limits<double>::epsilon();

/// Returns whether |value| ≤ max_rounding · magnitude, so that it counts as zero.
bool is_rounding(double value, double magnitude);

/// Returns whether an equation between constants holds within their roundings; true for any with a
/// table. Where it does not hold, two descriptions of what rests on the ground differ.
/// - reach: largest absolute coordinate of a point [unit of length], nominal or in a body's own
///   frame. Each coordinate may be off by max_rounding · reach
bool holds_to_rounding(const Model& model, const Constraint& constraint, double reach);

/// Returns whether the offset of a planar sliding joint has an equation of its own. It has none
/// when bodies have no frames, the joint is drawn without offset and its distance is declared. Then
/// the definition of the distance keeps the points on the line.
bool writes_offset(const EquationWriter& writer, const Mechanism::Joint& joint);

/// Returns the dimensions that a kind measures, zero where they are at rounding level.
///
/// - operands<S>(drawing): positions of the operands of the kind in a BodyDrawing<S>
/// - magnitude: that of the terms of which a dimension is a difference; 0: it is no difference
template <class Kind, class Operands>
std::array<Derived, Kind::constants> measured(const Mechanism& mechanism, double magnitude,
                                              const Operands& operands) {
  const auto in = [&]<MeasureScalar S>(const BodyDrawing<S>& drawing) {
    const auto positions = operands(drawing);
    static_assert(positions.size() <= Kind::operand_sizes.size());
    std::array<const S*, Kind::operand_sizes.size()> x{};
    for (std::size_t k = 0; k < positions.size(); ++k) x[k] = positions[k].data();
    std::array<S, Kind::constants> c;
    Kind::measure(x.data(), c.data());
    return c;
  };
  const std::array<double, Kind::constants> rounded = in(BodyDrawing<double>{mechanism});
  std::array<Derived, Kind::constants> c = in(BodyDrawing<Derived>{mechanism});
  for (int k = 0; k < Kind::constants; ++k)
    c[k] = is_rounding(rounded[k], magnitude) ? Derived(0) : c[k].about(rounded[k]);
  return c;
}

/// Returns the cᵢ with offset = Σ cᵢ directionᵢ for the basis of a body in space. Where there are
/// none, the sum is nearest to the offset. Coefficients at rounding level are zero. magnitude: that
/// of the positions of which the offset is a difference
std::vector<Derived> coefficients_in_space(const Mechanism& mechanism, const RigidBody& body,
                                           const Mechanism::Direction& offset, double magnitude);

/// Writes the equations within the bodies of a D-dimensional mechanism. Ground vectors that are
/// coordinates are held constant. Every other body keeps the scalar products of its basis, or
/// derives its frame; its other points and vectors are linear functions of these.
template <int D>
void write_body_equations(EquationWriter& writer);

/// Writes the equations of joints between different rigid bodies: offsets of planar sliding joints
/// (writes_offset()), angles of universal joints, distances from planes in space. Shared points and
/// vectors and relative coordinates imply all others. With frames, joints of the tree have none.
void write_joint_equations(EquationWriter& writer);

/// Writes the couplings of coordinates.
void write_coupling_equations(EquationWriter& writer);

/// Writes the definitions of relative coordinates, except for variables of tree joints, in D
/// dimensions. Throws std::invalid_argument, naming the coordinate or joint, when a definition does
/// not fit the nominal position or cannot be written.
template <int D>
void write_coordinate_equations(EquationWriter& writer);

}  // namespace desmo
