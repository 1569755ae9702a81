// Columns that `desmo solve` writes for each instant.
#pragma once

#include <string>
#include <vector>

#include "cases/mechanism/scene.h"
#include "formulations/formulation.h"
#include "formulations/planning/plan.h"

namespace desmo::cli {

/// A column: one number for each instant.
struct Column {
  std::string name;  ///< "C.x", "d/dt C.x", "d2/dt2 C.x"
  std::string unit;  ///< "m", "m/s", "m/s^2"; "rad", …; "-" for unit vectors; "1" for a free length
  Level level;
  int coordinate = -1;  ///< position in q, q̇ or q̈; -1: a constant
  double constant = 0;

  double value(const Instant& instant) const {
    if (coordinate < 0) return constant;
    return (level == Level::position   ? instant.q
            : level == Level::velocity ? instant.qd
                                       : instant.qdd)[coordinate];
  }
};

/// Returns the columns of an entity up to a level.
std::vector<Column> columns_of(const Model& model, const Output& output);

/// Entity by entity in the order asked for: positions, velocities and
/// accelerations as far as asked. Where everything is asked for, what never moves is left out.
std::vector<Column> make_columns(const Plan& plan, const Scene& scene);

}  // namespace desmo::cli
