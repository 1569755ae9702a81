// desmo_growth [BODIES...]: how reading, analysing and solving a mechanism file grow with the
// number of bodies, for generated files of both scalable cases, in CPU seconds; a step is the
// fastest of a few. Default: 100 1000 10000.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/suite/cpu_clock.h"
#include "cases/cases.h"
#include "cases/files.h"
#include "formulations/modelling/model.h"
#include "formulations/variants.h"

namespace {

using namespace desmo;
using suite::cpu_now;

constexpr int steps = 20;
/// Rounding leaves more in the squared lengths of links that are ten thousand lengths from the
/// origin than the usual tolerance allows; Newton's last step goes far below either.
constexpr double tolerance = 1e-7;

int bodies_of(std::string_view text) {
  int bodies = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), bodies);
  if (error != std::errc{} || end != text.data() + text.size() || bodies < 20 || bodies > 1'000'000)
    throw std::invalid_argument("'" + std::string(text) + "' is not a number of bodies, 20 to 1e6");
  return bodies;
}

/// Bodies of a case with two units less those with one, ground and crank left out.
int bodies_per_unit(const Case& c) {
  return static_cast<int>(c.describe(2).mechanism.bodies.size() -
                          c.describe(1).mechanism.bodies.size());
}

void measure(const Case& c, int bodies) {
  const Scene scene = c.describe(std::max(1, bodies / bodies_per_unit(c)));
  const std::string text = write_mechanism(scene.mechanism);

  const double start = cpu_now();
  const Description description = parse_mechanism(text, std::string(c.name));
  const double read = cpu_now();
  const Mechanism m = model(description, scene.motions).mechanism;
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
              static_cast<int>(c.name.size()), c.name.data(), description.bodies.size() - 1,
              m.coordinates(), blocks, static_cast<double>(text.size()) / 1024, read - start,
              modelled - read, cut - modelled, constructed - cut, fastest * 1e6);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    std::vector<int> sizes;
    for (int i = 1; i < argc; ++i) sizes.push_back(bodies_of(argv[i]));
    if (sizes.empty()) sizes = {100, 1000, 10'000};
    std::printf("%-18s %8s %8s %8s %8s %9s %9s %9s %9s %12s\n", "case", "bodies", "q", "blocks",
                "KiB", "read s", "model s", "blocks s", "setup s", "us/step");
    for (const Case& c : cases())
      for (const int bodies : sizes) measure(c, bodies);
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_growth: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_growth: " << e.what() << '\n';
    return 1;
  }
}
