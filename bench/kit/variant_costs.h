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

/// Returns why a variant's library is too slow to be timed with many coordinates; empty: it is not.
/// Says nothing of dense global solves (is_dense_global()).
inline std::string_view slow_reason(const Variant& variant) {
  const Backend* const backend = find_backend(variant.algebra);
  if (!backend) return {};
  if (variant.partition == Partition::block && backend->slow_reason.empty())
    return backend->slow_blocks_reason;
  return backend->slow_reason;
}

}  // namespace desmo::bench
