// All kinds of constraints, and operands as their functions take them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <tuple>
#include <utility>

#include "formulations/constraints/constraints.h"

namespace desmo {

/// Returns where the values of each operand begin.
template <class Values, std::size_t N>
auto pointers(const std::array<Values, N>& x) {
  std::array<const typename Values::value_type*, N> p;
  for (std::size_t k = 0; k < N; ++k) p[k] = x[k].data();
  return p;
}

template <class... Kinds>
testing::Types<Kinds...> types_of(const std::tuple<Kinds...>&);

/// The kinds for which typed tests run.
using EveryKind = decltype(types_of(std::declval<ConstraintKinds>()));

}  // namespace desmo
