#pragma once

#include <boost/multiprecision/float128.hpp>
#include <vector>

namespace desmo {

using Quadruple = boost::multiprecision::float128;

/// A solved instant in coordinate order, in quadruple precision, fixed entities left out.
struct WideInstant {
  double time;  ///< s
  std::vector<Quadruple> q, qd, qdd;
};

}  // namespace desmo
