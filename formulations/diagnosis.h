#pragma once

#include <span>
#include <vector>

#include "cases/mechanism.h"
#include "formulations/part.h"

namespace desmo {

/// Where a step failed. -1 where it cannot be told.
struct Culprit {
  GroupId group = -1;
  int constraint = -1;  ///< position in Mechanism::constraints
};

/// Finds the group that stopped a part, from the positions where it stopped. The equations of a
/// group do not depend on later groups, so groups before the one that cannot be solved converge
/// even in a global solve: the culprit is the first whose equations are not finite, or not
/// satisfied, or, after a singular factorisation, the one nearest to singular on its own.
/// The constraint is the one worst satisfied or, if singular, the one most involved in the
/// dependence. Not for timed code: it allocates and decomposes.
/// state: Mechanism::state_size() values. tolerance: ‖Φ‖₂ above which a group is unsatisfied.
Culprit find_culprit(const Mechanism& mechanism, std::span<const GroupId> groups,
                     std::span<const double> state, Status status, double tolerance);

}  // namespace desmo
