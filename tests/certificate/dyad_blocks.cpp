// Batches of dyads against their exact positions, where their lanes share pivots that suit none,
// and where errors are as usual.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "tests/certificate/product_block.h"

namespace desmo::dyad_blocks_test {
namespace {

using Point = std::array<double, 2>;

/// Two centres and the point where links from them meet.
struct Dyad {
  std::array<Point, 2> centres;
  Point meeting;
};

/// A batch of dyads whose links are as long as they are drawn, to twice the digits of a double. The
/// centres are fixed; coordinates of meeting point k are 2 k and 2 k + 1.
struct Dyads {
  explicit Dyads(const std::vector<Dyad>& dyads) {
    Model m;
    const GroupId group = m.add_group("dyads", {});
    for (const Dyad& dyad : dyads) m.add(EntityKind::point, "meeting", dyad.meeting, group);
    std::vector<BlockBatch::PlacedBlock> placed;
    for (int k = 0; k < static_cast<int>(dyads.size()); ++k) {
      const auto& [centres, meeting] = dyads[k];
      for (const Point& centre : centres) {
        const Derived x = Derived(meeting[0]) - centre[0], y = Derived(meeting[1]) - centre[1];
        const EntityId fixed = m.add_fixed(EntityKind::point, "centre", centre);
        m.add({"link", kind_index<Length<2>>(), {fixed, k}, {x * x + y * y}, group});
      }
    }
    for (int k = 0; k < static_cast<int>(dyads.size()); ++k)
      placed.push_back(placed_block(m, {.groups = {group},
                                        .unknowns = {2 * k, 2 * k + 1},
                                        .equations = {{2 * k, 0}, {2 * k + 1, 0}}}));
    batch.emplace(placed, std::vector<double>(m.coordinates(), 1), 0);
    errors = tables_of(m.state_size());
    const std::vector<double> drawn = m.state_of(m.estimate);
    for (int i = 0; i < m.state_size(); ++i) errors.position.rows[i].delivered = drawn[i];
  }

  LaneMask prove() { return proof_for(*batch).prove(*batch, Level::position, errors).position; }

  std::optional<BlockBatch> batch;
  PerLevel<ErrorTable> errors;
};

TEST(BlockProof, HoldsWherePivotsSuitOneLaneOnly) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double slant : {1e-15, 1e-9, 1e-5, 0.3})
    for (int trial = 0; trial < (DESMO_SANITIZED ? 5 : 50); ++trial) {
      // Links nearly along the axes: what is a good pivot in one lane is a poor one in the other.
      const Point p{uniform(generator), uniform(generator)};
      const Point beside{p[0] - 1, p[1] - slant}, below{p[0] - slant, p[1] - 1};
      Dyads dyads({Dyad{{beside, below}, p}, Dyad{{below, beside}, p}});
      std::vector<ErrorTable::Row>& rows = dyads.errors.position.rows;
      for (int i = 0; i < 4; ++i) rows[i].delivered += 1e-12 * uniform(generator);
      const LaneMask proven = dyads.prove();
      for (int i = 0; i < 4; ++i) {
        EXPECT_TRUE(proven[i / 2]) << slant;
        const double error = std::abs(p[i % 2] - rows[i].delivered);
        EXPECT_LE(error, rows[i].sum) << slant;
        EXPECT_LE(rows[i].sum, 1.01 * error + 1e-16);
      }
    }
}

/// Links at an angle of 1e-4 rad, of a condition of 20,000, and an error of four times the default
/// tolerance. The first X holds it, so that there is no second one: that would be far narrower
/// along the links, where the error is small. X is 1e-11, and its square costs no digit.
TEST(BlockProof, HoldsUsualErrorsInTheFirstX) {
  const Dyad dyad{{Point{0, 0}, Point{0, 1e-4}}, {1, 0}};
  Dyads dyads({dyad});
  ErrorTable& e = dyads.errors.position;
  for (auto* values : {&e.radius, &e.correction, &e.rest}) values->resize(2);
  e.rows[1].delivered = 4e-12;
  ASSERT_TRUE(dyads.prove()[0]);
  e.write_bounds();
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(dyads.batch->jacobian.radius[i][0], 1e-11);  // 2 X, for Φ is of second degree
    EXPECT_LE(e.rest[i], 0x1p-56);
    EXPECT_LE(std::abs(dyad.meeting[i] - e.rows[i].delivered - e.correction[i]), e.rest[i]);
  }
}

}  // namespace
}  // namespace desmo::dyad_blocks_test
