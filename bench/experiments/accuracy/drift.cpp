#include "bench/experiments/accuracy/drift.h"

#include <charconv>
#include <cstdio>
#include <stdexcept>
#include <string_view>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/reference/drift.h"

namespace desmo::accuracy {

namespace {

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

bool measure(const Scene& scene, const Variant& variant, int steps, double tolerance) {
  const Model m = make_model(scene);
  const auto f = make_formulation(variant, m, {.tolerance = tolerance});
  const Drift d = measure_drift(*f, {scene.grid.start, scene.grid.step, steps + 1}, window);
  std::printf("%s, %d coordinates, %s, %d steps of %g s: %s\n", m.name.c_str(), m.coordinates(),
              variant.id.c_str(), steps, scene.grid.step, describe(d.summary, m).c_str());
  if (!d.summary.ok()) return false;
  std::printf("%-14s %12s %12s %12s %12s %12s\n", "", "first max", "last max", "first rms",
              "last rms", "floor");
  constexpr const char* names[] = {"position", "velocity", "acceleration"};
  for (const Level level : levels)
    std::printf("%-14s %12.2e %12.2e %12.2e %12.2e %12.2e\n", names[static_cast<int>(level)],
                d.first[level].max, d.last[level].max, d.first[level].rms, d.last[level].rms,
                d.floor[level]);
  return true;
}

}  // namespace

bool print_drift(const std::vector<std::string>& words) {
  if (words.size() < 2 || words.size() > 4)
    throw std::invalid_argument("--drift takes MECHANISM ID [STEPS [TOLERANCE]]");
  const Scene scene = find_scene(words[0]);
  return measure(scene, find_variant(words[1]),
                 words.size() > 2 ? parse<int>(words[2], "a number of steps", 1) : 1'000'000,
                 words.size() > 3 ? parse<double>(words[3], "a tolerance", 0) : scene.tolerance);
}

}  // namespace desmo::accuracy
