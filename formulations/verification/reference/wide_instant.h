#pragma once

#include <boost/multiprecision/float128.hpp>
#include <vector>

#include "formulations/base/reference_instant.h"

namespace desmo {

using Quadruple = boost::multiprecision::float128;

/// A solved instant in quadruple precision, in coordinate order without fixed entities.
struct WideInstant {
  double time;  ///< [s]
  std::vector<Quadruple> q, qd, qdd;
};

/// Returns an instant rounded to double, with what that leaves.
ReferenceInstant rounded(const WideInstant& wide);

}  // namespace desmo
