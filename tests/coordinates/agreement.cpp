// Every kind of coordinates, on the library and both cases, against the quadruple reference of the
// natural model.

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "formulations/modelling/modelling.h"
#include "formulations/verification/reference/reference.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"
#include "tests/named_difference.h"

namespace desmo::coordinates_test {
namespace {

std::vector<Scene> motions() {
  std::vector<Scene> all = library_scenes();
  if (DESMO_SANITIZED)
    for (Scene& scene : all) scene.grid.instants = std::min(scene.grid.instants, 11);
  for (Scene scene : {four_bar(1), four_bar(8), truck_suspension(1), truck_suspension(2)}) {
    scene.grid = time_grid(DESMO_SANITIZED ? 0.05 : 0.5, 0.01);
    all.push_back(std::move(scene));
  }
  return all;
}

TEST(Coordinates, DeliverTheNaturalMotionWhateverTheyAre) {
  for (const Scene& scene : motions()) {
    const TimeGrid& grid = scene.grid;
    const Model natural = make_model(scene);
    std::vector<double> times;
    for (int i = 0; i < grid.instants; i += std::max(1, grid.instants / 10))
      times.push_back(grid.time(i));
    const Reference reference = make_reference(natural, times);
    for (const auto& [kind, settings] :
         {std::pair{Modelling::basis, "/coordinates:basis"},
          {Modelling::reference, "/coordinates:reference"},
          {Modelling::reference, "/coordinates:reference/frames:exact"},
          {Modelling::relative, "/coordinates:relative"},
          {Modelling::relative, "/coordinates:relative/frames:exact"}}) {
      const std::string where = natural.name + " in " + settings;
      SCOPED_TRACE(where);
      Model m;
      ASSERT_NO_THROW(m = make_model(scene, kind)) << where;
      for (const char* partition : {"global", "group", "block"})
        for (const char* algebra : {"lapack", "klu"}) {
          const std::string id = std::string(partition) + "_automatic_" + algebra + settings;
          NamedDifference difference(m, natural, reference.instants);
          const Summary s = formulated(id, m)->run(grid, {}, difference);
          EXPECT_TRUE(s.ok()) << id << ": " << describe(s, m);
          difference.expect_agreement(id);
        }
    }
  }
}

/// Returns Newton's iterations in the assembly and ten steps of a tenth of a second.
long iterations(const Model& m, const std::string& id) {
  const auto f = formulated(id, m);
  Summary total = f->assemble(0);
  for (int i = 1; i <= 10; ++i) total.add(f->step(0.1 * i));
  EXPECT_TRUE(total.ok()) << m.name << " " << id << ": " << describe(total, m);
  return total.iterations;
}

/// In the long chain bodies hang on each other. From its drawing, iterations with exact frames
/// would lead away: an assembly takes linearised ones.
TEST(Coordinates, TakeNoMoreIterationsWithExactFrames) {
  for (const auto& [kind, coordinates] : {std::pair{Modelling::reference, "/coordinates:reference"},
                                          {Modelling::relative, "/coordinates:relative"}})
    for (const Scene& scene : {truck_suspension(1), four_bar(DESMO_SANITIZED ? 20 : 140)}) {
      const Model m = make_model(scene, kind);
      for (const char* partition : {"global", "group"}) {
        const std::string id = std::string(partition) + "_automatic_klu" + coordinates;
        EXPECT_LE(iterations(m, id + "/frames:exact"), iterations(m, id)) << m.name << " " << id;
      }
    }
}

/// A part whose unknowns are all derived has no closure whose residual would be NaN.
TEST(Coordinates, ThatAreNoNumbersAreNoneWithExactFrames) {
  const Model m = make_model(four_bar(1), Modelling::relative);
  const auto f = formulated("block_automatic_klu/coordinates:relative/frames:exact", m);
  ASSERT_TRUE(f->assemble(0).ok());
  EXPECT_EQ(f->step(NAN).status, Status::not_finite);
}

}  // namespace
}  // namespace desmo::coordinates_test
