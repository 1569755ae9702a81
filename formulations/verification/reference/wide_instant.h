#pragma once

#include <boost/multiprecision/float128.hpp>
#include <span>
#include <vector>

#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "formulations/model/scales.h"

namespace desmo {

using Quadruple = boost::multiprecision::float128;

/// A solved instant in quadruple precision, in coordinate order without fixed entities.
struct WideInstant {
  double time;  ///< [s]
  std::vector<Quadruple> q, qd, qdd;
};

/// Returns an instant rounded to double, with the remainders of the rounding.
ReferenceInstant rounded(const WideInstant& wide);

/// Returns the largest difference of two solutions over all outputs (see ErrorMeasure) and
/// instants, relative to the scales. Both have the same instants. Differences are taken in
/// quadruple precision.
PerLevel<double> disagreement(const Model& model, std::span<const WideInstant> a,
                              std::span<const WideInstant> b, const Scales& scales);

}  // namespace desmo
