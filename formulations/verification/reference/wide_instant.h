#pragma once

#include <boost/multiprecision/float128.hpp>
#include <vector>

namespace desmo {

using Quadruple = boost::multiprecision::float128;

/// A solved instant in quadruple precision, in coordinate order without fixed entities.
struct WideInstant {
  double time;  ///< [s]
  std::vector<Quadruple> q, qd, qdd;
};

}  // namespace desmo
