#pragma once

#include <cmath>
#include <string>
#include <vector>

#include "cases/extremes/rows.h"
#include "formulations/modelling/modelling.h"

namespace desmo::range_test {

struct Links {
  double crank, coupler, rocker, ground;

  /// Returns the crank's angle where crank pin and pivot are so far apart.
  double angle_at(double distance) const {
    return std::acos((crank * crank + ground * ground - distance * distance) /
                     (2 * crank * ground));
  }
};

/// A four-bar with its crank at an angle; several if pivots are at the same place.
inline Model four_bar(const Links& links, double start, int side = 1, double unit = 1,
                      int dyads = 1) {
  MechanismBuilder builder("four_bar", 2);
  builder.set_length_unit("1");
  for (int i = 0; i < dyads; ++i) {
    DyadChain chain = extremes::one_dyad(unit * links.crank, start, unit * links.ground,
                                         unit * links.coupler, unit * links.rocker, side);
    chain.prefix = std::to_string(i);
    add(builder, chain);
  }
  std::vector<Motion> motions(dyads, Polynomial{{start}});
  return model_mechanism(builder.release(), motions).model;
}

}  // namespace desmo::range_test
