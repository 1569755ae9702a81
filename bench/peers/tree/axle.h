#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

/// The position of a rigid axle: its point S and its axes, with their rates.
struct Pose {
  Moving<Vec> s, x, y, z;

  /// Returns a point fixed to the axle, given from S in its frame.
  Moving<Vec> at(const Vec& local) const { return s + local[0] * x + local[1] * y + local[2] * z; }
};

/// Bodies 2 to 5 of an axle of truck_suspension: the axle, on an arm that turns about the lateral
/// axis, and its two lower rods. Relative coordinates: the arm's angle, and yaw ψ, roll ρ and pitch
/// θ of the axle, whose frame at the arm's end S is Rz(ψ) Rx(ρ) Ry(θ). The rods close the loops,
/// and the heights of the wheels are given.
///
/// With this order of turns the heights leave two unknowns. Their difference divided by the track
/// is sin ρ; with θ they give the height of S, hence the arm's angle. ψ and θ keep the rods'
/// lengths:
///   gᵢ = (‖Cᵢ − Gᵢ‖² − Lᵢ²)/2 = 0.
/// This holds for the case, whose wheels are apart along y2 alone and whose S − R is normal to y1.
class Axle {
 public:
  /// The unknowns of Newton's method, ψ and θ [rad], and their rates. They are 0 in the nominal
  /// position.
  struct Angles {
    std::span<double, 2> q, qd, qdd;
  };

  /// prefix: first part of the axle's names. tolerance: limit (<) of √Σ (gᵢ/Lᵢ²)².
  Axle(const Mechanism& mechanism, const std::string& prefix, double tolerance);

  /// Returns the names of the entities that deliver() writes, in its order.
  static std::vector<std::string> delivered(const std::string& prefix);

  /// Solves at the given heights of the wheels. angles: start of Newton's method; receives the
  /// solution. Returns the number of iterations. Throws std::runtime_error, naming the axle, when
  /// the heights are out of reach or Newton's method does not close the loops.
  int solve(const Moving<double>& left, const Moving<double>& right, const Angles& angles);

  /// Returns the pose of the axle at the last solution.
  const Pose& pose() const { return pose_; }
  /// Writes the coordinates of delivered() at the last solution.
  void deliver(AnswerWriter& out) const;

 private:
  struct Rod {
    Vec c;  ///< C on the axle: C − S in the axle's frame
    Vec g;  ///< G on the chassis
    double length;
  };
  struct Roll;
  struct Closure;

  Roll roll(const Moving<double>& left, const Moving<double>& right) const;
  Closure closure(const Angles& angles, const Roll& roll) const;
  void solve_rates(const Closure& at, const Roll& roll, const Angles& angles);

  std::string prefix_;
  double tolerance_;
  Vec pivot_;         // R, the point of the chassis about which the arm turns
  double arm_;        // length of the arm, with the sign of the x component of S − R
  Vec left_, right_;  // wheel centres, from S in the axle's frame
  double track_;      // distance of the wheel centres along y2
  std::array<Rod, 2> rods_;

  Pose pose_;
  Moving<double> left_height_, right_height_;
};

}  // namespace desmo::tree
