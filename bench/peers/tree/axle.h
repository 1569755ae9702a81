#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

/// The position of a rigid axle: its point S and its frame.
struct Pose {
  Moving<Vec> s, x, y, z;

  /// Returns a point fixed to the axle, given from S in its frame.
  Moving<Vec> at(const Vec& local) const { return s + local[0] * x + local[1] * y + local[2] * z; }
};

/// Bodies 2 to 5 of an axle of truck_suspension: the axle, on an arm that turns about the lateral
/// axis, and its two lower rods. Relative coordinates: the arm's angle, and yaw ψ, roll ρ and pitch
/// θ of the axle on the arm's end, R = Rz(ψ) Rx(ρ) Ry(θ). The rods close the loops, and the heights
/// of the wheels are given.
///
/// The heights, in this order of turns, leave two unknowns: their difference over the track is sin
/// ρ, and with θ they are the height of S, hence the arm's angle. ψ and θ keep the rods' lengths:
///   gᵢ = (‖Cᵢ − Gᵢ‖² − Lᵢ²)/2 = 0.
/// This holds for the case, whose wheels are apart along y2 alone and whose S − R is normal to y1.
class Axle {
 public:
  /// ψ and θ, what Newton's method looks for. They are 0 in the nominal position.
  struct Angles {
    std::span<double, 2> q, qd, qdd;
  };

  /// prefix: of the axle's names.
  Axle(const Mechanism& mechanism, const std::string& prefix, double tolerance);

  /// Names of what solve() delivers, in its order.
  static std::vector<std::string> delivered(const std::string& prefix);

  /// Solves at the given heights of the wheels, starting from the angles given. They become the
  /// solution's. Returns the iterations. Throws std::runtime_error, naming the axle, when the
  /// heights are out of reach or Newton's method does not close the loops.
  int solve(const Moving<double>& left, const Moving<double>& right, const Angles& angles);

  /// Returns the pose of the axle at the last solution.
  const Pose& pose() const { return pose_; }
  /// Everything of these bodies at the last solution.
  void deliver(AnswerWriter& out) const;

 private:
  struct Rod {
    Vec c;  ///< on the axle, from S in its frame
    Vec g;  ///< on the chassis
    double length;
  };
  struct Roll;
  struct Closure;

  Roll roll(const Moving<double>& left, const Moving<double>& right) const;
  Closure closure(const Angles& angles, const Roll& roll) const;
  void solve_rates(const Closure& at, const Roll& roll, const Angles& angles);

  std::string prefix_;
  double tolerance_;  // of √Σ (gᵢ/Lᵢ²)²
  Vec pivot_;         // R, the arm's
  double arm_;        // its length, with the sign of x of S − R
  Vec left_, right_;  // wheel centres on the axle
  double track_;      // between them, along y2
  std::array<Rod, 2> rods_;

  Pose pose_;
  Moving<double> left_height_, right_height_;
};

}  // namespace desmo::tree
