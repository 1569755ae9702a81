#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "formulations/base/reference_instant.h"
#include "formulations/verification/certificate/certificate.h"

namespace desmo {

/// Returns the instant that a formulation would deliver.
inline Instant instant_of(const ReferenceInstant& s) {
  return {.index = 0, .time = s.time, .q = s.q, .qd = s.qd, .qdd = s.qdd};
}

/// Returns an instant with all positions moved but those of drivers.
inline ReferenceInstant moved(const Model& m, ReferenceInstant instant, double off) {
  const std::vector<bool> driven = independent_coordinates(m);
  for (int i = 0; i < m.coordinates(); ++i)
    if (!driven[i]) instant.q[i] += off * (i % 2 == 0 ? 1 : -1);
  return instant;
}

/// What certificates of many instants say, compared with exact solutions.
struct Containment {
  int instants = 0, proven = 0;
  PerLevel<double> widest;               ///< largest finite radius
  PerLevel<std::vector<double>> ratios;  ///< of radius and error, where there is an error

  double median(Level level) {
    std::vector<double>& r = ratios[level];
    if (r.empty()) return 0;
    std::ranges::nth_element(r, r.begin() + static_cast<std::ptrdiff_t>(r.size() / 2));
    return r[r.size() / 2];
  }

  /// Adds a delivered instant, and expects that no radius is below the error.
  Certificate add(Certifier& certifier, const ReferenceInstant& delivered,
                  const ReferenceInstant& exact, ErrorSets sets = ErrorSets::boxes) {
    const Certificate c = certifier.certify(instant_of(delivered), sets);
    ++instants;
    proven += c.proven;
    compare(Level::position, c, delivered.q, exact.q, exact.remainder.q);
    compare(Level::velocity, c, delivered.qd, exact.qd, exact.remainder.qd);
    compare(Level::acceleration, c, delivered.qdd, exact.qdd, exact.remainder.qdd);
    return c;
  }

 private:
  void compare(Level level, const Certificate& c, const std::vector<double>& value,
               const std::vector<double>& nearest, const std::vector<double>& remainder) {
    for (std::size_t i = 0; i < value.size(); ++i) {
      const double radius = c.radius[level][i];
      const double error = std::abs((value[i] - nearest[i]) - remainder[i]);
      EXPECT_LE(error, radius) << "level " << static_cast<int>(level) << ", coordinate " << i
                               << ", time " << instants;
      EXPECT_TRUE(!c.proven || std::isfinite(radius));
      if (std::isfinite(radius)) widest[level] = std::max(widest[level], radius);
      if (error > 0) ratios[level].push_back(radius / error);
    }
  }
};

}  // namespace desmo
