#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/builder.h"

namespace desmo {

/// A driven crank about the origin and a chain of dyads (coupler and rocker), each attached to the
/// previous one by its coupler. A closed form solves this plane mechanism for any lengths.
struct DyadChain {
  struct Dyad {
    Mechanism::Vec pivot;    ///< pivot of the rocker on the ground
    double coupler, rocker;  ///< lengths of the links
    /// Approximate position of the joint of coupler and rocker. Its side of the line from the
    /// coupler's start to the pivot determines the dyad's branch.
    Mechanism::Vec joint;
    double angle;  ///< approximate angle of the rocker [rad]
  };

  double crank;             ///< length of the crank
  double start;             ///< initial angle of the crank [rad]
  std::vector<Dyad> dyads;  ///< dyads along the chain; each is a structural group
  std::string prefix = {};  ///< prefix of all names
};

/// Adds a chain to a mechanism. The crank's angle becomes the next driven coordinate.
void add(MechanismBuilder& builder, const DyadChain& chain);

/// Returns the initial position of the crank's pin.
Mechanism::Vec crank_pin(const DyadChain& chain);

/// Returns a dyad whose coupler starts at `from`, with the joint where both lengths hold. The joint
/// lies to the left of the line from `from` to `pivot` for side 1, to the right for −1. Where the
/// lengths do not meet, the joint is put on this line.
DyadChain::Dyad closed_dyad(const Mechanism::Vec& from, const Mechanism::Vec& pivot, double coupler,
                            double rocker, int side);

}  // namespace desmo
