// Operands of a constraint kind, as its functions take them.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace desmo {

/// Returns where the values of each operand begin.
template <class S, std::size_t N>
std::array<const S*, N> pointers(const std::array<std::vector<S>, N>& x) {
  std::array<const S*, N> p;
  for (std::size_t k = 0; k < N; ++k) p[k] = x[k].data();
  return p;
}

}  // namespace desmo
