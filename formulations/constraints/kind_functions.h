#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "formulations/constraints/constraints.h"
#include "formulations/constraints/kinds.h"

namespace desmo {

/// Returns an array of make(Kind()) of each kind.
template <class Make>
constexpr auto table_of_kinds(const Make& make) {
  return [&]<std::size_t... I>(std::index_sequence<I...>) {
    return std::array{make(std::tuple_element_t<I, ConstraintKinds>{})...};
  }
  (std::make_index_sequence<constraint_kind_count>{});
}

template <class S>
void KindFunctions<S>::residual(int kind, const S* const* x, const S* c, S* phi) {
  static constexpr auto functions =
      table_of_kinds([]<class Kind>(Kind) { return &Kind::template residual<S>; });
  functions[kind](x, c, phi);
}

template <class S>
void KindFunctions<S>::jacobian(int kind, const S* const* x, const S* c, S* values) {
  static constexpr auto functions = table_of_kinds([]<class Kind>(Kind) {
    return +[](const S* const* at, const S* constants, S* to) {
      Kind::jacobian(at, constants, [&](int, int, int, const S& value) { *to++ = value; });
    };
  });
  functions[kind](x, c, values);
}

template <class S>
void KindFunctions<S>::quadratic(int kind, const S* const* x, const S* const* v, const S* c,
                                 S* gamma) {
  static constexpr auto functions =
      table_of_kinds([]<class Kind>(Kind) { return &Kind::template quadratic<S>; });
  functions[kind](x, v, c, gamma);
}

}  // namespace desmo
