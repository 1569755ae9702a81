// Proven radii against quadruple precision, over motions of whole mechanisms.

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>

#include "formulations/groupwise/double_solution.h"
#include "formulations/verification/certificate/certificate.h"
#include "formulations/verification/reference/reference.h"
#include "tests/accuracy/scenes.h"

namespace desmo::certificate_test {
namespace {

struct Found {
  int proven = 0, instants = 0;
  PerLevel<double> widest, loosest, median;
};

void expect_containment(const Model& m, const TimeGrid& grid, int instants) {
  const std::vector<double> times = sampled(grid, instants);
  const auto solved = double_solution(m, times);
  const auto exact = reference_solution(m, times, Precision::quadruple);
  Certifier certifier(m);
  int proven = 0;
  PerLevel<double> widest;
  PerLevel<std::vector<double>> ratios;
  for (std::size_t k = 0; k < times.size(); ++k) {
    const ReferenceInstant& s = solved[k];
    const Certificate c =
        certifier.certify({.index = 0, .time = s.time, .q = s.q, .qd = s.qd, .qdd = s.qdd});
    proven += c.proven;
    const auto compare = [&](Level level, const auto& value, const auto& nearest,
                             const auto& rest) {
      for (int i = 0; i < m.coordinates(); ++i) {
        const double radius = c.radius[level][i];
        const double error = std::abs((value[i] - nearest[i]) - rest[i]);
        EXPECT_LE(error, radius) << m.name << " level " << int(level) << " coordinate " << i
                                 << " at " << s.time;
        if (std::isfinite(radius)) widest[level] = std::max(widest[level], radius);
        if (error > 0) ratios[level].push_back(radius / error);
      }
    };
    const ReferenceInstant& e = exact[k];
    compare(Level::position, s.q, e.q, e.rest.q);
    compare(Level::velocity, s.qd, e.qd, e.rest.qd);
    compare(Level::acceleration, s.qdd, e.qdd, e.rest.qdd);
  }
  std::cout << m.name << ": " << proven << " of " << times.size();
  for (Level l : levels) {
    auto& r = ratios[l];
    std::ranges::sort(r);
    std::cout << "  widest " << widest[l] << " median " << (r.empty() ? 0 : r[r.size() / 2]);
  }
  std::cout << '\n';
  EXPECT_EQ(proven, static_cast<int>(times.size())) << m.name;
}

TEST(Certificate, HoldsOnTheLibrary) {
  for (const LibraryMechanism& l : library()) {
    const Scene scene = library_scene(l.name);
    expect_containment(make_model(scene), scene.grid, 100);
  }
}

TEST(Certificate, HoldsOnTheCases) {
  for (const Case& c : cases()) {
    const Scene scene = describe(c, c.sizes.back());
    expect_containment(make_model(scene), scene.grid, 20);
  }
}

}  // namespace
}  // namespace desmo::certificate_test
