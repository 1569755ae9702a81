#include "bench/experiments/size/analysis.h"

#include <algorithm>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/time/cpu_clock.h"
#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"

namespace desmo::size {

namespace {

using bench::cpu_now;

constexpr int steps = 20;
/// Rounding leaves more in the squared lengths of links that are ten thousand lengths from the
/// origin than the usual tolerance allows; Newton's last step goes far below either.
constexpr double tolerance = 1e-7;

/// Bodies of a case with two units less those with one, ground and crank left out.
int bodies_per_unit(const Case& c) {
  return static_cast<int>(c.describe(2).mechanism.bodies.size() -
                          c.describe(1).mechanism.bodies.size());
}

void measure(const Case& c, int bodies) {
  const Scene scene = c.describe(std::max(1, bodies / bodies_per_unit(c)));
  const std::string text = write_mechanism(scene.mechanism);

  const double start = cpu_now();
  const Mechanism mechanism = parse_mechanism(text, std::string(c.name));
  const double read = cpu_now();
  const Model m = model_mechanism(mechanism, scene.motions).model;
  const double modelled = cpu_now();
  const std::size_t blocks = make_partition(m, Partition::block).size();
  const double cut = cpu_now();
  const auto formulation =
      make_formulation(find_variant("group_symbolic_inlined"), m, Settings{tolerance, 25});
  const double constructed = cpu_now();

  double fastest = std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i) {
    const double before = cpu_now();
    const Summary s = formulation->step(i * scene.grid.step);
    fastest = std::min(fastest, cpu_now() - before);
    if (!s.ok()) throw std::runtime_error(describe(s, m));
  }

  std::printf("%-18.*s %8zu %8d %8zu %8.1f %9.4f %9.4f %9.4f %9.4f %12.2f\n",
              static_cast<int>(c.name.size()), c.name.data(), mechanism.bodies.size() - 1,
              m.coordinates(), blocks, static_cast<double>(text.size()) / 1024, read - start,
              modelled - read, cut - modelled, constructed - cut, fastest * 1e6);
}

}  // namespace

void print_analysis(const std::vector<int>& bodies) {
  std::printf("%-18s %8s %8s %8s %8s %9s %9s %9s %9s %12s\n", "case", "bodies", "q", "blocks",
              "KiB", "read s", "model s", "blocks s", "setup s", "us/step");
  for (const Case& c : cases())
    for (const int number : bodies) measure(c, number);
}

}  // namespace desmo::size
