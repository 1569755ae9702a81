// Batches of dyads against quadruple precision, where their lanes share pivots that suit none, and
// where errors are as usual.

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/float128.hpp>
#include <random>
#include <vector>

#include "tests/certificate/product_block.h"

namespace desmo::dyad_blocks_test {
namespace {

using Wide = boost::multiprecision::float128;
using Point = std::array<double, 2>;

/// Two centres and the point where links from them meet.
struct Dyad {
  std::array<Point, 2> centres;
  Point meeting;

  std::array<double, 2> squares() const {
    std::array<double, 2> all;
    for (int k = 0; k < 2; ++k) {
      const double x = meeting[0] - centres[k][0], y = meeting[1] - centres[k][1];
      all[k] = x * x + y * y;
    }
    return all;
  }
  /// Returns the exact meeting point of links with these squares.
  std::array<Wide, 2> exact() const {
    std::array<Wide, 2> p{meeting[0], meeting[1]};
    for (int iteration = 0; iteration < 8; ++iteration) {
      std::array<Wide, 2> x, y, phi;
      for (int k = 0; k < 2; ++k) {
        x[k] = p[0] - centres[k][0], y[k] = p[1] - centres[k][1];
        phi[k] = x[k] * x[k] + y[k] * y[k] - squares()[k];
      }
      const Wide twice = 2 * (x[0] * y[1] - x[1] * y[0]);
      p[0] -= (phi[0] * y[1] - phi[1] * y[0]) / twice;
      p[1] -= (x[0] * phi[1] - x[1] * phi[0]) / twice;
    }
    return p;
  }
};

/// A dyad as block of two equations: its coordinates are 2 k and 2 k + 1, its centres are fixed.
BlockBatch::Member member(int k, const Dyad& dyad) {
  BlockBatch::Member made{{}, 0, k, Level::acceleration, {2 * k, 2 * k + 1}};
  BlockShape& s = made.block.shape;
  s.unknowns = 2;
  s.linear = false;
  s.columns = {0, 1, BlockShape::fixed, BlockShape::fixed, BlockShape::fixed, BlockShape::fixed};
  s.entries = s.column_rows = {0, 1, 0, 1};
  s.row_begins = s.column_begins = {0, 2, 4};
  s.input_begins = {2, 4};
  s.column_rows = {0, 1, 0, 1};
  s.column_entries = {0, 2, 1, 3};
  for (int row = 0; row < 2; ++row) {  // Jacobian::entries: of the first point, then of the second
    const int first = 2 * row;
    s.objects.push_back(
        {kind_index<Length<2>>(), {2 + first, 0}, {row, -1, -1}, row, {-1, first, -1, first + 1}});
  }
  for (int i = 0; i < 2; ++i) made.block.states.push_back(2 * k + i);
  for (int i = 0; i < 4; ++i) made.block.states.push_back(4 + 4 * k + i);
  made.block.coordinates = made.rows;
  made.block.constants = {dyad.squares()[0], dyad.squares()[1]};
  return made;
}

TEST(BlockProof, HoldsWherePivotsSuitOneLaneOnly) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (const double slant : {1e-15, 1e-9, 1e-5, 0.3})
    for (int trial = 0; trial < (DESMO_SANITIZED ? 5 : 50); ++trial) {
      // Links nearly along the axes: what is a good pivot in one lane is a poor one in the other.
      const Point p{uniform(generator), uniform(generator)};
      const Point beside{p[0] - 1, p[1] - slant}, below{p[0] - slant, p[1] - 1};
      const std::array<Dyad, 2> dyads{Dyad{{beside, below}, p}, Dyad{{below, beside}, p}};
      std::vector<BlockBatch::Member> members;
      for (int k = 0; k < 2; ++k) members.push_back(member(k, dyads[k]));
      BlockBatch batch(members, {1, 1, 1, 1}, 0);
      PerLevel<ErrorTable> errors = tables_of(12);
      for (int k = 0; k < 2; ++k)
        for (int i = 0; i < 2; ++i) {
          errors.position.rows[2 * k + i].delivered = p[i] + 1e-12 * uniform(generator);
          for (int c = 0; c < 2; ++c)
            errors.position.rows[4 + 4 * k + 2 * c + i].delivered = dyads[k].centres[c][i];
        }
      BlockProof proof({.unknowns = 2, .width = 2, .states = 6, .columns = 0});
      const PerLevel<LaneMask> proven = proof.prove(batch, Level::position, errors);
      for (int k = 0; k < 2; ++k) {
        EXPECT_TRUE(proven.position[k]) << slant;
        for (int i = 0; i < 2; ++i) {
          const double delivered = errors.position.rows[2 * k + i].delivered;
          const Wide error = abs(dyads[k].exact()[i] - delivered);
          EXPECT_LE(error, Wide(errors.position.rows[2 * k + i].sum)) << slant;
          EXPECT_LE(errors.position.rows[2 * k + i].sum, 1.01 * static_cast<double>(error) + 1e-16);
        }
      }
    }
}

/// Links at an angle of 1e-4 rad, of a condition of 20,000, and an error of four times the default
/// tolerance. The first X holds it, so that there is no second one: that would be far narrower
/// along the links, where the error is small. X is 1e-11, and its square costs no digit.
TEST(BlockProof, HoldsUsualErrorsInTheFirstX) {
  const Dyad dyad{{Point{0, 0}, Point{0, 1e-4}}, {1, 0}};
  const BlockBatch::Member made = member(0, dyad);
  BlockBatch batch(std::span(&made, 1), {1, 1}, 0);
  PerLevel<ErrorTable> errors = tables_of(8);
  ErrorTable& e = errors.position;
  for (auto* values : {&e.radius, &e.correction, &e.rest}) values->resize(2);
  e.rows[0].delivered = 1;
  e.rows[1].delivered = 4e-12;
  e.rows[7].delivered = dyad.centres[1][1];
  BlockProof proof({.unknowns = 2, .width = 2, .states = 6, .columns = 0});
  ASSERT_TRUE(proof.prove(batch, Level::position, errors).position[0]);
  e.write_bounds();
  for (int i = 0; i < 2; ++i) {
    EXPECT_GT(batch.jacobian.radius[i][0], 1e-11);  // 2 X, for Φ is of second degree
    EXPECT_LE(e.rest[i], 0x1p-56);
    const Wide error = abs(dyad.exact()[i] - e.rows[i].delivered - e.correction[i]);
    EXPECT_LE(error, Wide(e.rest[i]));
  }
}

}  // namespace
}  // namespace desmo::dyad_blocks_test
