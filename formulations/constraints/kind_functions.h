#pragma once

#include "formulations/constraints/constraints.h"
#include "formulations/constraints/kinds.h"

namespace desmo {

template <class S>
void KindFunctions<S>::residual(int kind, const S* const* x, const S* c, S* phi) {
  visit_kind(kind, [&]<class Kind>(Kind) { Kind::residual(x, c, phi); });
}

template <class S>
void KindFunctions<S>::jacobian(int kind, const S* const* x, const S* c, S* values) {
  visit_kind(kind, [&]<class Kind>(Kind) {
    Kind::jacobian(x, c, [&](int, int, int, const S& value) { *values++ = value; });
  });
}

template <class S>
void KindFunctions<S>::quadratic(int kind, const S* const* x, const S* const* v, const S* c,
                                 S* gamma) {
  visit_kind(kind, [&]<class Kind>(Kind) { Kind::quadratic(x, v, c, gamma); });
}

}  // namespace desmo
