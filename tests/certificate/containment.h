#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "formulations/verification/certificate/certificate.h"
#include "tests/checked/rows.h"

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

/// Comparison of the certificates of many instants with exact solutions.
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
    EXPECT_EQ(c.proven, c.failure == ProofFailure::none);
    const PerLevel<std::span<const double>> values{delivered.q, delivered.qd, delivered.qdd};
    for (const Level level : all_levels)
      for (int i = 0; i < std::ssize(values[level]); ++i) {
        const double radius = c.radius[level][i],
                     error = error_of(values[level][i], exact, level, i);
        EXPECT_LE(error, radius) << "level " << static_cast<int>(level) << ", coordinate " << i
                                 << ", time " << instants;
        EXPECT_TRUE(!c.proven || std::isfinite(radius));
        if (std::isfinite(radius)) widest[level] = std::max(widest[level], radius);
        if (error > 0) ratios[level].push_back(radius / error);
      }
    return c;
  }
};

}  // namespace desmo
