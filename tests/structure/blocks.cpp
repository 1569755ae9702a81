// The irreducible blocks of the equations inside structural groups.

#include <gtest/gtest.h>

#include <map>
#include <set>
#include <utility>
#include <vector>

#include "cases/generators/cases.h"
#include "formulations/model/incidence.h"
#include "formulations/model/partition.h"
#include "tests/mechanisms.h"

namespace desmo::blocks_test {
namespace {

/// Parts are square, cover unknowns and equations once each, and read only what is found before.
void expect_solvable_in_order(const Model& m, Partition partition) {
  std::vector<bool> found(m.state_size(), false);
  for (int i = m.coordinates(); i < m.state_size(); ++i) found[i] = true;
  const std::vector<bool> driven = independent_coordinates(m);
  int unknown_count = 0, equation_count = 0;
  for (int i = 0; i < m.coordinates(); ++i) {
    found[i] = driven[i];
    unknown_count += !driven[i];
  }
  for (const Constraint& c : m.constraints) equation_count += kept_rows(c);
  std::set<std::pair<int, int>> equations;
  int unknowns_covered = 0;
  for (const PartDefinition& b : make_partition(m, partition)) {
    EXPECT_EQ(b.unknowns.size(), b.equations.size());
    for (const int i : b.unknowns) {
      EXPECT_FALSE(found[i]) << "found twice";
      found[i] = true;
      ++unknowns_covered;
    }
    for (const Equation& e : b.equations) {
      EXPECT_TRUE(equations.emplace(e.constraint, e.row).second) << "stated twice";
      EXPECT_FALSE(m.constraints[e.constraint].left_out >> e.row & 1);
      visit_incidence(m, m.constraints[e.constraint], [&](int row, int state) {
        EXPECT_TRUE(row != e.row || found[state])
            << m.constraints[e.constraint].name << " reads ahead";
      });
    }
  }
  EXPECT_EQ(unknowns_covered, unknown_count);
  EXPECT_EQ(static_cast<int>(equations.size()), equation_count);
}

void expect_solvable_in_order(const Model& m) {
  for (const Partition partition : {Partition::global, Partition::group, Partition::block})
    expect_solvable_in_order(m, partition);
}

TEST(Parts, AreSquareCoverEverythingAndReadOnlyWhatIsFoundBefore) {
  expect_solvable_in_order(truck_model(3));
  expect_solvable_in_order(four_bar_model(9));
  for (const char* name : {"watt_six_bar", "stephenson_six_bar", "stewart"})
    expect_solvable_in_order(make_model(library_scene(name)));
}

TEST(Blocks, OfTheTrucksFirstGroupAreOneOfSixteenSixOfThreeAndFiveOfOne) {
  // Sixteen: the axle's WL.x, WL.y, x2, y2, z2 with S, C4.. as far as its arms hold them.
  const Model m = truck_model(1);
  std::map<std::size_t, int> sizes;
  for (const PartDefinition& b : make_partition(m, Partition::block))
    if (b.groups.front() == 1) ++sizes[b.unknowns.size()];
  EXPECT_EQ(sizes, (std::map<std::size_t, int>{{16, 1}, {3, 6}, {1, 5}}));
}

TEST(Blocks, OfAnOrderedChainAreItsSmallestSteps) {
  // Crank: B.x and B.y from θ. Dyad: C and ψ together, from length and angle.
  const Model m = four_bar_model(3);
  std::vector<std::size_t> sizes;
  for (const PartDefinition& b : make_partition(m, Partition::block))
    sizes.push_back(b.unknowns.size());
  EXPECT_EQ(sizes, (std::vector<std::size_t>{1, 1, 3, 3, 3}));
}

}  // namespace
}  // namespace desmo::blocks_test
