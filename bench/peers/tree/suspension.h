#pragma once

#include <array>
#include <string>
#include <vector>

#include "bench/peers/tree/axle.h"
#include "bench/peers/tree/moving.h"
#include "cases/mechanism/mechanism.h"

namespace desmo::tree {

/// A lever of the stabiliser, on the axle, and its link to the chassis. Symbols:
///
///   A        lever's joint on the axle            B   joint of lever and link
///   G        link's joint on the chassis          D   A − G
///   x2, z2   axes of the axle's frame             e   direction of the lever, from A to B
///   λ        length of the lever, ‖B − A‖         L   length of the link, ‖B − G‖
///
/// Relative coordinate: the lever's angle φ, which the link's length gives in closed form:
///   ‖D + λ e‖ = L,  e = −cos φ x2 + sin φ z2.
class Stabiliser {
 public:
  /// prefix: first part of the axle's names. lever, link: the bodies' numbers, "6" and "8".
  Stabiliser(const Mechanism& mechanism, const std::string& prefix, const std::string& lever,
             const std::string& link);

  /// Returns the names of the entities that solve() writes, in its order.
  static std::vector<std::string> delivered(const std::string& prefix, const std::string& lever,
                                            const std::string& link);

  /// Solves at a pose of the axle, and writes the entities of delivered(). Throws
  /// std::runtime_error, naming the lever, when its link does not reach it.
  void solve(const Pose& axle, AnswerWriter& out) const;

 private:
  std::string name_;     // name of the lever
  Vec a_;                // A − S in the axle's frame
  Vec g_;                // G
  double lever_, link_;  // λ and L
  double side_;          // sign of w (see solve()) in the nominal position, which the lever keeps
};

/// Rod and tube of a damper, from A on the axle to T on the chassis. Relative coordinate: the
/// length s, which T − A gives.
class Damper {
 public:
  /// prefix: first part of the axle's names. rod, tube: the bodies' numbers, "10" and "11".
  Damper(const Mechanism& mechanism, const std::string& prefix, const std::string& rod,
         const std::string& tube);

  /// Returns the names of the entities that solve() writes, in its order.
  static std::vector<std::string> delivered(const std::string& prefix, const std::string& rod,
                                            const std::string& tube);

  void solve(const Pose& axle, AnswerWriter& out) const;

 private:
  Vec a_;  // A − S in the axle's frame
  Vec t_;  // T on the chassis
};

/// An axle with all that hangs on it.
struct Suspension {
  Suspension(const Mechanism& mechanism, const std::string& prefix, double tolerance)
      : axle(mechanism, prefix, tolerance),
        stabilisers{Stabiliser(mechanism, prefix, "6", "8"),
                    Stabiliser(mechanism, prefix, "7", "9")},
        dampers{Damper(mechanism, prefix, "10", "11"), Damper(mechanism, prefix, "12", "13")} {}

  Axle axle;
  std::array<Stabiliser, 2> stabilisers;
  std::array<Damper, 2> dampers;
};

}  // namespace desmo::tree
