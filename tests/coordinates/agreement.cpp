// Every kind of coordinates, on the library and both cases, against the quadruple reference of the
// natural model.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "cases/generators/cases.h"
#include "cases/io/files.h"
#include "cases/library/library.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/reference/reference.h"
#include "tests/formulated.h"

namespace desmo::coordinates_test {
namespace {

struct Motion {
  Scene scene;
  TimeGrid grid;
};

std::vector<Motion> motions() {
  std::vector<Motion> all;
  const double seconds = DESMO_SANITIZED ? 0.05 : 0.5;
  for (const LibraryMechanism& l : library()) {
    Scene scene = library_scene(std::string(l.name));
    TimeGrid grid = scene.grid;
    if (DESMO_SANITIZED) grid.instants = std::min(grid.instants, 11);
    all.push_back({std::move(scene), grid});
  }
  for (const int units : {1, 8}) all.push_back({four_bar(units), time_grid(seconds, 0.01)});
  for (const int units : {1, 2}) all.push_back({truck_suspension(units), time_grid(seconds, 0.01)});
  return all;
}

/// The largest differences from the reference of another model, whose entities have the same names.
class NamedDifference final : public Observer {
 public:
  NamedDifference(const Model& m, const Model& natural, const Reference& reference)
      : reference_(reference) {
    for (const Entity& e : natural.entities) {
      if (e.fixed) continue;
      const Entity& same = m.entities[m.find(e.name)];
      EXPECT_EQ(same.size, e.size) << e.name;
      EXPECT_FALSE(same.internal) << e.name;
      for (int i = 0; i < e.size; ++i) {
        from_.push_back(e.first + i);
        to_.push_back(same.fixed ? -1 : same.first + i);
        names_.push_back(e.name);
      }
    }
  }

  Flow observe(const Instant& instant) noexcept override {
    if (seen == reference_.instants.size() ||
        std::abs(instant.time - reference_.instants[seen].time) > 1e-9)
      return Flow::go_on;
    const ReferenceInstant& r = reference_.instants[seen++];
    widen(of.position, instant.q, r.q);
    widen(of.velocity, instant.qd, r.qd);
    widen(of.acceleration, instant.qdd, r.qdd);
    return Flow::go_on;
  }

  PerLevel<double> of{};
  std::size_t seen = 0;
  std::string worst;

 private:
  void widen(double& largest, std::span<const double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < from_.size(); ++i)
      if (const double off = to_[i] < 0 ? 0 : std::abs(a[to_[i]] - b[from_[i]]);
          !(off <= largest)) {
        largest = off;
        worst = names_[i];
      }
  }

  const Reference& reference_;
  std::vector<int> from_, to_;
  std::vector<std::string> names_;
};

TEST(Coordinates, DeliverTheNaturalMotionWhateverTheyAre) {
  for (const auto& [scene, grid] : motions()) {
    const Model natural = make_model(scene);
    std::vector<double> times;
    for (int i = 0; i < grid.instants; i += std::max(1, grid.instants / 10))
      times.push_back(grid.time(i));
    const Reference reference = make_reference(natural, times);
    for (const auto& [kind, name] : {std::pair{Modelling::basis, "basis"},
                                     {Modelling::reference, "reference"},
                                     {Modelling::relative, "relative"}}) {
      const std::string where = natural.name + " in " + name;
      SCOPED_TRACE(where);
      Model m;
      ASSERT_NO_THROW(m = make_model(scene, kind)) << where;
      for (const char* partition : {"global", "group", "block"})
        for (const char* algebra : {"lapack", "klu"}) {
          const std::string id =
              std::string(partition) + "_automatic_" + algebra + "/coordinates:" + name;
          NamedDifference difference(m, natural, reference);
          const Summary s = formulated(id, m)->run(grid, {}, difference);
          EXPECT_TRUE(s.ok()) << id << ": " << describe(s, m);
          EXPECT_EQ(difference.seen, times.size()) << id;
          EXPECT_LE(difference.of.position, 1e-9) << id << " " << difference.worst;
          EXPECT_LE(difference.of.velocity, 1e-8) << id << " " << difference.worst;
          EXPECT_LE(difference.of.acceleration, 1e-7) << id << " " << difference.worst;
        }
    }
  }
}

}  // namespace
}  // namespace desmo::coordinates_test
