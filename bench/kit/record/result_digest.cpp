#include "bench/kit/record/result_digest.h"

#include <cmath>
#include <limits>

namespace desmo::bench {

std::int64_t rounded(double value, double reference, double unit) {
  const double counted = std::abs(value - reference) <= unit ? reference : value;
  const double multiple = std::nearbyint(counted / unit);
  return std::abs(multiple) <= 1e18 ? static_cast<std::int64_t>(multiple)
                                    : std::numeric_limits<std::int64_t>::max();
}

void ResultDigest::add(double value, double reference, double unit) {
  digest_.add(std::to_string(rounded(value, reference, unit)) + ' ');
}

}  // namespace desmo::bench
