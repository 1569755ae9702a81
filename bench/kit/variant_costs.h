#pragma once

#include <string_view>

#include "formulations/algebra/backend.h"
#include "formulations/variants.h"

// Variants that are too slow to be solved or timed with many coordinates.

namespace desmo::bench {

/// Returns whether a variant solves all unknowns at once with dense matrices, at O(n³) a step.
inline bool is_dense_global(const Variant& variant) {
  const Backend* const backend = find_backend(variant.algebra);
  return variant.partition == Partition::global && backend && backend->dense;
}

/// Returns why a variant is too slow to be timed with many coordinates, though not dense: what it
/// serves instead. Empty: it is not.
inline std::string_view slow_reason(const Variant& variant) {
  const Backend* const backend = find_backend(variant.algebra);
  if (!backend) return {};
  if (variant.partition == Partition::block && backend->slow_reason.empty())
    return backend->slow_blocks_reason;
  return backend->slow_reason;
}

}  // namespace desmo::bench
