// Collects the tables of a set, for the files that define which sets a program has.
#pragma once

#include "formulations/equations/kernel_sets.h"

namespace desmo {

template <KernelSet set>
KernelTables tables_of() {
  KernelTables tables{kernels<set>(), explicit_kernels<set>(), lane_kernels<set, 4>(), {}};
#ifdef DESMO_WIDE_LANES
  tables.eight_lanes = lane_kernels<set, 8>();
#endif
  return tables;
}

}  // namespace desmo
