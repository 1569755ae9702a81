// Krawczyk's test of a block of one equation: each term that errors have is counted.

#include "formulations/verification/certificate/block_proof.h"

#include <gtest/gtest.h>

#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <cmath>
#include <vector>

#include "tests/certificate/product_block.h"

namespace desmo::block_proof_test {
namespace {

/// Errors of positions that cancel each other in a rate, but for what rounding loses.
TEST(BlockProof, CountsRoundingOfWhatLowerLevelsAdd) {
  using Exact = boost::multiprecision::cpp_rational;
  constexpr double s = 0x1p-20, lost = 0x1.fp-54 * s;  // less than half of the last place of s
  const std::array<double, 6> delivered{0.25, 0, 0, 1, -1, 0}, error{0, s, lost, lost, lost, -s},
      rates{1, 1, 1, 0, 1, 1};
  ProductBlock block(0.25);
  PerLevel<ErrorTable>& errors = block.errors;
  std::array<Exact, 6> exact;
  for (int i = 0; i < 6; ++i) {
    errors.position.rows[i] = {delivered[i], error[i], 0, std::abs(error[i])};
    errors.velocity.rows[i].delivered = rates[i];
    exact[i] = Exact(delivered[i]) + Exact(error[i]);
  }
  ASSERT_TRUE(block.prove(Level::velocity));
  // The rate of v₁ is zero, so that the first position does not matter.
  const Exact rate =
      -(rates[1] * exact[4] + rates[2] * exact[5] + rates[4] * exact[1] + rates[5] * exact[2]) /
      exact[3];
  EXPECT_GT(abs(rate - 1), 2 * Exact(lost));
  EXPECT_LE(abs(rate - 1), Exact(errors.velocity.rows[0].sum));
  EXPECT_LE(errors.velocity.rows[0].sum, 1e-18);
}

/// An input that is off by a known amount. The rate is off by all that a contraction of that amount
/// adds to its errors; at more than a half there is no proof.
TEST(BlockProof, CountsWhatErrorsOfRatesAddToThemselves) {
  const std::array<double, 6> delivered{1, 0, 0, 1, 1, 0}, rates{1, -1, 0, 0, 0, 0};
  int proven = 0;
  for (int percent = 5; percent < 100; percent += 5) {
    ProductBlock block(1);
    PerLevel<ErrorTable>& errors = block.errors;
    for (int i = 0; i < 6; ++i) {
      errors.position.rows[i].delivered = delivered[i];
      errors.velocity.rows[i].delivered = rates[i];
    }
    const double off = percent / 100.0;
    errors.position.rows[3] = {1, 0, off, off};
    if (!block.prove(Level::velocity)) continue;
    ++proven;
    const double largest = 1 / (1 - off) - 1;  // of u₁ v₁ = 1 and of its rate times v₁, which is 1
    for (const Level level : {Level::position, Level::velocity}) {
      EXPECT_LE(largest, errors[level].rows[0].sum) << off;
      EXPECT_LE(errors[level].rows[0].sum, 2.5 * largest) << off;
    }
  }
  EXPECT_GE(proven, 5);
}

/// An equation that may be off by an amount, which moves the unknown by twice that.
TEST(BlockProof, CountsByHowMuchAnEquationMayBeOff) {
  constexpr double slack = 1e-6;
  BlockBatch::PlacedBlock placed = product_of_vectors(1);
  placed.block.slack = {slack};
  ProductBlock block(placed);
  std::vector<ErrorTable::Row>& rows = block.errors.position.rows;
  rows[0].delivered = 2;
  rows[3].delivered = 0.5;
  ASSERT_TRUE(block.prove(Level::position));
  EXPECT_LE(2 * slack, rows[0].sum);
  EXPECT_LE(rows[0].sum, 2.01 * slack);
}

/// A lane that is proven at once keeps its X while another lane needs a larger one.
TEST(BlockProof, KeepsWhatIsProvenInOneLane) {
  constexpr double small = 0x1p-40, off = 0.3;
  const std::array<double, 2> products{small, 1}, delivered{small, 1.001};
  std::array<double, 2> radius;
  for (const int lanes : {1, 2}) {
    std::vector<BlockBatch::PlacedBlock> placed;
    for (int k = 0; k < lanes; ++k) {
      BlockBatch::PlacedBlock& made = placed.emplace_back(product_of_vectors(products[k]));
      for (int& row : made.rows) row += 6 * k;
      made.block.states = made.block.coordinates = made.rows;
    }
    BlockBatch batch(placed, std::vector<double>(12, 1), 0);
    PerLevel<ErrorTable> errors = tables_of(12);
    for (int k = 0; k < lanes; ++k) {
      errors.position.rows[6 * k].delivered = delivered[k];
      errors.position.rows[6 * k + 3].delivered = 1;
    }
    errors.position.rows[3] = {1, 0, off, off};
    BlockProof proof({.unknowns = 1, .width = 6, .states = 6, .columns = 0});
    const PerLevel<LaneMask> proven = proof.prove(batch, Level::position, errors);
    ASSERT_TRUE(proven.position[0] && proven.position[1]);
    radius[lanes - 1] = errors.position.rows[0].sum;
    EXPECT_LE(small / (1 - off) - small, radius[lanes - 1]);
    EXPECT_LE(radius[lanes - 1], 1e-11);
  }
  EXPECT_EQ(radius[0], radius[1]);
}

/// The driven component of v is off, or not known, by 0.6, which is too much, or x is off by more
/// than that.
TEST(BlockProof, SaysWhatMostOfAnErrorComesFrom) {
  const auto failure = [](double off, double unknown, double product) {
    ProductBlock block(product);
    ErrorTable& e = block.errors.position;
    for (auto* values : {&e.radius, &e.correction, &e.rest}) values->resize(6);
    e.rows[0].delivered = 1;
    e.rows[3] = {1, off, unknown, off + unknown};
    EXPECT_FALSE(block.prove(Level::position));
    return block.proof.failure(0);
  };
  EXPECT_EQ(failure(0.6, 0, 1), ProofFailure::drivers);
  EXPECT_EQ(failure(0, 0.6, 1), ProofFailure::time);
  EXPECT_EQ(failure(0, 0.6, 4), ProofFailure::far_off);  // 0.6 of 3.6
  EXPECT_EQ(failure(0, INFINITY, 1), ProofFailure::time);
}

}  // namespace
}  // namespace desmo::block_proof_test
