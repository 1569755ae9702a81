#pragma once

#include <experimental/simd>

#include "formulations/equations/lane_kernel.h"

// SIMD lanes for generated code, which is compiled once for each number of lanes and the processors
// that have the registers. The unnamed namespace keeps these versions apart.

#ifndef DESMO_LANES
#define DESMO_LANES 4
#endif
#if DESMO_LANES > 4
// Code for wide registers begins at a page. Moved by less than a cache line it may take a third
// longer. So its position must not depend on what is linked before it.
asm(".text\n.balign 4096");
#endif

namespace desmo {

namespace {

constexpr int lanes = DESMO_LANES;
using Lanes = std::experimental::simd<double, std::experimental::simd_abi::deduce_t<double, lanes>>;
static_assert(sizeof(Lanes) == lanes * sizeof(double) && alignof(Lanes) <= 64);

inline Lanes* in_lanes(double* values) { return reinterpret_cast<Lanes*>(values); }
inline const Lanes* in_lanes(const double* values) {
  return reinterpret_cast<const Lanes*>(values);
}

/// Wraps a kernel on registers as one on arrays of doubles.
template <ExplicitResult<Lanes> (*solve)(Lanes*, Lanes*, Lanes*, const ExplicitBinding<Lanes>&)>
LaneResult solve_lanes(double* q, double* qd, double* qdd, const ExplicitBinding<double>& parts,
                       double* residual2) {
  const auto& [in, c, f, branch, w, anchors, limits] = parts;
  const ExplicitResult<Lanes> r = solve(
      in_lanes(q), in_lanes(qd), in_lanes(qdd),
      {in, in_lanes(c), in_lanes(f), in_lanes(branch), in_lanes(w), in_lanes(anchors), limits});
  *in_lanes(residual2) = r.residual2;
  if (all(r.accepted)) return {(1u << lanes) - 1, r.iterations};
  unsigned accepted = 0;
  for (int l = 0; l < lanes; ++l) accepted |= static_cast<unsigned>(r.accepted[l]) << l;
  return {accepted, r.iterations};
}

}  // namespace

}  // namespace desmo
