// Every mechanism of the library, with every formulation, against its independent solution.

#include "cases/library/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

#include "cases/io/files.h"
#include "cases/mechanism/names.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "formulations/verification/error.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/library/solutions.h"

namespace desmo::library_test {
namespace {

/// Returns the independent solution at every instant of the scene, the same for all formulations.
/// Angles go on continuously from the drawing. What the file does not name stays as it is drawn.
const std::vector<ReferenceInstant>& exact_motion(const Scene& scene, const Model& m) {
  static std::map<std::string, std::vector<ReferenceInstant>> known;
  std::vector<ReferenceInstant>& motion = known[scene.mechanism.name];
  const auto at = exact::library_solutions().at(scene.mechanism.name);
  for (int i = static_cast<int>(motion.size()); i < scene.grid.instants; ++i) {
    const std::vector<double> zero(m.estimate.size());
    ReferenceInstant now{scene.grid.time(i), i == 0 ? m.estimate : motion.back().q, zero, zero};
    for (const auto& [name, exact] : at(now.time)) {
      const Entity& e = m.entities[m.find(name)];
      if (e.fixed) continue;
      EXPECT_EQ(e.size, exact.size) << name;
      const auto& [position, velocity, acceleration] = exact.levels;
      std::copy_n(velocity.begin(), e.size, now.qd.begin() + e.first);
      std::copy_n(acceleration.begin(), e.size, now.qdd.begin() + e.first);
      double* const q = &now.q[e.first];
      if (e.kind == EntityKind::angle)
        *q += std::remainder(position[0] - *q, 2 * std::numbers::pi);
      else
        std::copy_n(position.begin(), e.size, q);
    }
    motion.push_back(std::move(now));
  }
  return motion;
}

/// Returns all that the mechanism's file names.
std::vector<Output> named_outputs(const Model& m) {
  std::vector<Output> named;
  for (const auto& [name, exact] : exact::library_solutions().at(m.name)(0))
    named.push_back({m.find(name), Level::acceleration});
  return named;
}

class Library : public testing::TestWithParam<std::tuple<std::string_view, Variant>> {};

TEST_P(Library, AgreesWithTheIndependentSolution) {
  const auto& [mechanism, variant] = GetParam();
  Scene scene = library_scene(mechanism);
  // The whole motion in the optimised build; a part of it where every operation is checked.
  if (DESMO_TEST_SECONDS < 30) scene.grid.instants = std::min(scene.grid.instants, 61);
  const Model m = make_model(scene);
  const std::vector<ReferenceInstant>& exact = exact_motion(scene, m);
  ErrorMeasure measure(m, exact, make_scales(m, exact), named_outputs(m));
  const auto f = make_formulation(variant, m, Settings{scene.tolerance, 25});
  const Summary s = f->run(scene.grid, {}, measure);
  EXPECT_TRUE(s.ok()) << describe(s, m);
  const SolutionError error = measure.error();
  EXPECT_EQ(error.instants, scene.grid.instants);
  constexpr PerLevel<double> allowed{1e-9, 1e-8, 1e-7};
  for (const Level level : all_levels)
    EXPECT_LE(error[level].max, allowed[level]) << level_names[level];
}

INSTANTIATE_TEST_SUITE_P(All, Library,
                         testing::Combine(testing::ValuesIn(names_of(library())),
                                          testing::ValuesIn(tested_variants())),
                         [](const auto& info) {
                           return std::string(std::get<0>(info.param)) + "_" +
                                  std::get<1>(info.param).id;
                         });

TEST(LibraryTable, HasIndependentSolutionsOfEverythingNamedInTheFiles) {
  for (const auto& [mechanism, at] : exact::library_solutions()) {
    SCOPED_TRACE(mechanism);
    const Scene scene = library_scene(mechanism);
    std::vector<std::string> named, solved;
    for (const auto& p : scene.mechanism.points) named.push_back(p.name);
    for (const auto& v : scene.mechanism.vectors) named.push_back(v.name);
    for (const auto& c : scene.mechanism.coordinates) named.push_back(c.name);
    for (const auto& [name, q] : at(0)) solved.push_back(name);
    std::ranges::sort(named);
    EXPECT_EQ(named, solved);
    EXPECT_EQ(scene.mechanism.name, mechanism);
    EXPECT_GE(scene.grid.instants, 300);
  }
}

}  // namespace
}  // namespace desmo::library_test
