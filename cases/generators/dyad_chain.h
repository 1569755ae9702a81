#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/builder.h"

namespace desmo {

/// A driven crank about the origin and dyads, each hung on the one before by its coupler: a plane
/// mechanism that a closed form solves, whatever its lengths.
struct DyadChain {
  struct Dyad {
    Mechanism::Vec pivot;    ///< of the rocker, on the ground
    double coupler, rocker;  ///< lengths
    /// Where both meet, roughly. The side of the line from the coupler's beginning to the pivot on
    /// which it lies is the dyad's branch.
    Mechanism::Vec joint;
    double angle;  ///< of the rocker, roughly, rad
  };

  double crank;             ///< length
  double start;             ///< angle of the crank, rad
  std::vector<Dyad> dyads;  ///< as many groups, behind the crank's
  std::string prefix = {};  ///< of all names
};

/// Adds its bodies; the crank's angle becomes the next driven coordinate.
void add(MechanismBuilder& builder, const DyadChain& chain);

/// Where the crank's pin is at its start.
Mechanism::Vec crank_pin(const DyadChain& chain);

/// A dyad that hangs at `from` and is closed there: side 1 has its joint to the left of the way
/// from there to the pivot, -1 to the right. Where it cannot be closed, it is stretched.
DyadChain::Dyad closed_dyad(const Mechanism::Vec& from, const Mechanism::Vec& pivot, double coupler,
                            double rocker, int side);

}  // namespace desmo
