// Mechanisms with random dimensions, sizes and places: every kind of coordinates has their natural
// motion.

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/mechanism/drawing.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "tests/everything.h"
#include "tests/properties/mechanisms.h"

namespace desmo::properties {
namespace {

const TimeGrid grid = time_grid(0.5, 0.01);

/// Drives a mechanism from its drawing a short way along its path.
std::vector<Motion> short_way(const Drawn& drawn) {
  std::vector<Motion> motions;
  for (const Mechanism::Coordinate& c : drawn.mechanism.coordinates) {
    if (!c.driven) continue;
    const double start = c.estimate ? *c.estimate : Drawing<double>{drawn.mechanism}.value(c);
    motions.push_back(Polynomial{{start, 0.06 * drawn.reach * drawn.direction[motions.size()]}});
  }
  return motions;
}

/// Returns the positions of all instants; none where the motion cannot be solved.
std::vector<std::vector<double>> positions(const Model& m, const std::string& id) {
  Everything all(grid.instants);
  const Summary s = formulated(id, m)->run(grid, {}, all);
  if (!s.ok()) all.all.clear();
  return std::move(all.all);
}

TEST(DrawnMechanisms, MoveAlikeInAllCoordinates) {
  int compared = 0;
  for (const Family& family : families()) {
    Random random(1);
    const Drawn drawn = draw(family, random);
    const std::vector<Motion> motions = short_way(drawn);
    const Model natural = model_mechanism(drawn.mechanism, motions).model;
    const auto expected = positions(natural, "group_automatic_klu");
    if (expected.empty()) continue;  // it locks
    for (const auto& [kind, name] : {std::pair{Modelling::basis, "basis"},
                                     {Modelling::reference, "reference"},
                                     {Modelling::relative, "relative"}}) {
      const std::string where = std::string(family.name) + " in " + name;
      const Model m = model_mechanism(drawn.mechanism, motions, kind).model;
      const auto found = positions(m, std::string("group_automatic_klu/coordinates:") + name);
      ASSERT_EQ(found.size(), expected.size()) << where;
      double largest = 0;
      for (const Entity& e : natural.entities) {
        if (e.fixed) continue;
        const double scale = is_length(e.kind) ? nominal_size(natural) : 1;
        const int first = m.entities[m.find(e.name)].first;
        for (std::size_t t = 0; t < expected.size(); ++t)
          for (int i = 0; i < e.size; ++i)
            largest = larger_error(
                largest, std::abs(found[t][first + i] - expected[t][e.first + i]) / scale);
      }
      EXPECT_LE(largest, 1e-8) << where;
      ++compared;
    }
  }
  EXPECT_GE(compared, 3 * 20);
}

}  // namespace
}  // namespace desmo::properties
