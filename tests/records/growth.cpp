// Analysis and solution of generated mechanism files grow near linearly with the number of bodies.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <string>

#include "bench/kit/time/clock.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/model/partition.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"

namespace desmo::growth_test {
namespace {

struct Times {
  double analysis;  ///< reading, modelling, and finding the blocks [s]
  double step = std::numeric_limits<double>::infinity();  ///< the fastest of some [s]
};

Times measure(const Case& c, int units) {
  const Scene scene = c.with_units(units);
  const std::string text = write_mechanism(scene.mechanism);
  const double start = bench::cpu_now();
  const Mechanism mechanism = parse_mechanism(text, std::string(c.name));
  const Model m = model_mechanism(mechanism, scene.motions).model;
  EXPECT_GT(make_partition(m, Partition::block).size(), 100u);
  Times times{.analysis = bench::cpu_now() - start};
  const auto f = make_formulation(find_variant("group_symbolic_inlined"), m, {.tolerance = 1e-7});
  for (int i = 0; i <= 20; ++i) {
    const double before = bench::cpu_now();
    EXPECT_TRUE(f->step(i * scene.grid.step).ok());
    times.step = std::min(times.step, bench::cpu_now() - before);
  }
  return times;
}

TEST(FileGrowth, IsNearLinearUpToTenThousandBodies) {
  for (const Case& c : cases()) {
    const auto bodies_of = [&](int units) { return c.with_units(units).mechanism.bodies.size(); };
    const int units = static_cast<int>(10'000 / (bodies_of(2) - bodies_of(1)));
    const Times some = measure(c, units / 10), many = measure(c, units);
    // Ten times the bodies: a quadratic cost would show as 100. The bound leaves room for a cache
    // that no longer holds everything and for a neighbour that shares it.
    EXPECT_LT(many.analysis, 40 * some.analysis) << c.name;
    EXPECT_LT(many.step, 40 * some.step) << c.name;
  }
}

}  // namespace
}  // namespace desmo::growth_test
