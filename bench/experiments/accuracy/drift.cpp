// desmo_drift MECHANISM ID [STEPS [TOLERANCE]]: does the error grow in a long run? Errors of the
// first and the last 1000 of so many steps (10⁶), relative to the mechanism's scales, against the
// quadruple reference. MECHANISM is <case>/<coordinates> or a mechanism of the library, ID a
// formulation. The step is the scene's; the motion goes on beyond the scene's end.

#include "formulations/accuracy/drift.h"

#include <charconv>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>

#include "cases/cases.h"
#include "cases/files.h"
#include "cases/library.h"
#include "formulations/modelling/model.h"
#include "formulations/variants.h"

namespace {

using namespace desmo;

constexpr int window = 1000;

template <class Number>
Number parse(std::string_view text, const char* what, Number least) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !(value >= least))
    throw std::invalid_argument("'" + std::string(text) + "' is not " + what);
  return value;
}

Scene find_scene(std::string_view name) {
  if (const auto slash = name.find('/'); slash != std::string_view::npos)
    return describe(find_case(name.substr(0, slash)),
                    parse<int>(name.substr(slash + 1), "a number of coordinates", 1));
  const LibraryMechanism* l = find_library(name);
  if (l == nullptr)
    throw std::invalid_argument("no mechanism '" + std::string(name) +
                                "' in the library, and no <case>/<coordinates>");
  return parse_scene(l->scene, std::string(name) + ".scene.json", "");
}

int measure(const Scene& scene, const Variant& variant, int steps, double tolerance) {
  const Mechanism m = make_mechanism(scene);
  const auto f = make_formulation(variant, m, {.tolerance = tolerance});
  const Drift d = measure_drift(*f, {scene.grid.start, scene.grid.step, steps + 1}, window);
  std::printf("%s, %d coordinates, %s, %d steps of %g s: %s\n", m.name.c_str(), m.coordinates(),
              variant.id.c_str(), steps, scene.grid.step, describe(d.summary, m).c_str());
  if (!d.summary.ok()) return 1;
  std::printf("%-14s %12s %12s %12s %12s %12s\n", "", "first max", "last max", "first rms",
              "last rms", "floor");
  constexpr const char* names[] = {"position", "velocity", "acceleration"};
  for (const Level level : levels)
    std::printf("%-14s %12.2e %12.2e %12.2e %12.2e %12.2e\n", names[static_cast<int>(level)],
                d.first[level].max, d.last[level].max, d.first[level].rms, d.last[level].rms,
                d.floor[level]);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc < 3 || argc > 5)
      throw std::invalid_argument("usage: desmo_drift MECHANISM ID [STEPS [TOLERANCE]]");
    const Scene scene = find_scene(argv[1]);
    return measure(scene, find_variant(argv[2]),
                   argc > 3 ? parse<int>(argv[3], "a number of steps", 1) : 1'000'000,
                   argc > 4 ? parse<double>(argv[4], "a tolerance", 0) : scene.tolerance);
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_drift: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_drift: " << e.what() << '\n';
    return 1;
  }
}
