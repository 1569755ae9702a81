#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "formulations/algebra/backend.h"

namespace desmo {

/// The value `mixed` of the axis algebra: every part is made by the backend that measurement found
/// fastest for its type, and is that backend's own part. (Settings::scalar, which has a `mixed`
/// too, is about the digits of factors.)
extern const Backend mixed_backend;

/// Which of these times stands for the fastest, by position: one takes the place of an earlier one
/// only where it is more than 5 % faster. What measures as equal is thus decided by the order, and
/// not by noise. Infinite: of no use; where all are, the first.
std::size_t fastest(std::span<const double> seconds);

/// Which backend solves the parts of a type, sparse ones coming first in the order. Found once for
/// each type, way of evaluating its equations, and settings on which the work of a step depends;
/// the same is then said for as long as this lives, so that equal parts have equal solvers, in
/// every formulation. For any number of threads.
class BackendChoice {
 public:
  /// Seconds of a step of the part with each of these backends; infinite where it cannot be taken.
  using Measure =
      std::function<std::vector<double>(const PartContext&, std::span<const Backend* const>)>;

  /// backends: one or more, which outlive this; some sparse.
  BackendChoice(std::span<const Backend* const> backends, Measure measure)
      : backends_(backends), measure_(std::move(measure)) {}

  const Backend& of(const PartContext& part);

 private:
  std::span<const Backend* const> backends_;
  Measure measure_;
  std::mutex mutex_;  // one type is measured at a time
  std::map<std::string, const Backend*> chosen_;
};

}  // namespace desmo
