// Rounding in the proof of linear blocks, in exact arithmetic. All their equations are homogeneous,
// so where nothing else moves, what is delivered is the error.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "tests/certificate/product_block.h"

namespace desmo::linear_blocks_test {
namespace {

constexpr int dimensions = 3, summands = 4;
using Kind = Combination<dimensions, summands>;

/// An equation p = Σ cₖ eₖ of points p, e₀ … e₃: unknowns come first, then inputs.
struct Equation {
  std::array<int, summands + 1> points;
  std::array<double, summands> c;
};

/// Points of a block, their errors and the proof.
class Block {
 public:
  Block(int unknowns, int inputs, const std::vector<Equation>& equations) {
    Model m;
    PartDefinition part{.groups = {m.add_group("block", {})}, .unknowns = {}, .equations = {}};
    const std::array<double, dimensions> origin{};
    for (int k = 0; k < unknowns + inputs; ++k)
      m.add(EntityKind::point, "P" + std::to_string(k), origin, part.groups[0]);
    for (int i = 0; i < dimensions * unknowns; ++i) part.unknowns.push_back(i);
    for (const Equation& e : equations) {
      const int constraint = static_cast<int>(m.constraints.size());
      for (int row = 0; row < dimensions; ++row) part.equations.push_back({constraint, row});
      m.add({.name = "sum",
             .kind = kind_index<Kind>(),
             .operands = {e.points.begin(), e.points.end()},
             .constants = {e.c.begin(), e.c.end()},
             .group = part.groups[0]});
    }
    batch_.emplace(std::vector{placed_block(m, part)}, std::vector<double>(m.coordinates(), 1), 0);
    errors_.position.rows.resize(m.coordinates());
  }

  void deliver(int point, double value) {
    for (int i = 0; i < dimensions; ++i)
      errors_.position.rows[dimensions * point + i].delivered = value;
  }
  /// The input is off by exactly this.
  void set_error(int point, double error) {
    for (int i = 0; i < dimensions; ++i) {
      ErrorTable::Row& row = errors_.position.rows[dimensions * point + i];
      row = {row.delivered, error, 0, std::abs(error)};
    }
  }
  bool prove() { return proof_for(*batch_).prove(*batch_, Level::position, errors_).position[0]; }
  double radius(int point) const { return errors_.position.rows[dimensions * point].sum; }

 private:
  std::optional<BlockBatch> batch_;
  PerLevel<ErrorTable> errors_;
};

/// Two equations that hardly differ: what Y and I − Y Φ_φ lose by rounding is 1e4 to 1e8 times as
/// much.
TEST(LinearBlock, HoldsWhereItIsIllConditioned) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(0.5, 1);
  for (const double apart : {1e-4, 1e-6, 1e-8})
    for (int trial = 0; trial < (DESMO_SANITIZED ? 10 : 300); ++trial) {
      const double c = uniform(generator), s = uniform(generator);
      Block block(2, 3,
                  {{{0, 1, 2, 3, 4}, {c, 1, 1, 1}}, {{0, 1, 2, 3, 4}, {c + apart * s, 1, 1, 1}}});
      for (int input = 2; input < 5; ++input) block.set_error(input, 0);
      const double e = uniform(generator), p = c * e + apart * uniform(generator);
      block.deliver(0, p);
      block.deliver(1, e);
      ASSERT_TRUE(block.prove());
      EXPECT_LE(p, block.radius(0)) << apart;
      EXPECT_LE(e, block.radius(1)) << apart;
    }
}

/// Less than half of the last place of 1, which rounding loses.
constexpr double lost = 0x1.fp-54;

/// A residual and errors of inputs that cancel each other, but for what is lost.
TEST(LinearBlock, HoldsWhereErrorsOfInputsAreLost) {
  Block block(1, 4, {{{0, 1, 2, 3, 4}, {1, 1, 1, 1}}});
  block.deliver(0, 1);
  for (int input = 1; input < 4; ++input) block.set_error(input, -lost);
  block.set_error(4, 1);
  ASSERT_TRUE(block.prove());
  EXPECT_LE(3 * lost, block.radius(0));
  EXPECT_LE(block.radius(0), 1e-13);
}

/// Residuals that cancel each other, and many small ones between them that are lost.
TEST(LinearBlock, HoldsWhereSmallResidualsAreLost) {
  constexpr int points = 48;
  // Points s₀ … s₄₇, and sums p₁ = s₀ + s₄₇, p₂ = p₁ + s₁, p₃ = p₂ + s₂ …, all at the origin.
  constexpr int last = 2 * points - 2, input = last + 1;
  std::vector<Equation> equations;
  for (int k = 0; k < points; ++k)
    equations.push_back({{k, input, input + 1, input + 2, input + 3}, {1, 1, 1, 1}});
  for (int k = 0; k + 1 < points; ++k) {
    const int before = k == 0 ? points - 1 : points + k - 1;
    equations.push_back({{points + k, before, k, input, input + 1}, {1, 1, 1, 1}});
  }
  Block block(last + 1, 4, equations);
  for (int i = 0; i < 4; ++i) block.set_error(input + i, 0);
  block.deliver(0, 1);
  block.deliver(points - 1, -1);
  for (int k = 1; k < points - 1; ++k) block.deliver(k, lost);
  block.deliver(last, (points - 2) * lost);
  ASSERT_TRUE(block.prove());
  EXPECT_LE((points - 2) * lost, block.radius(last));
}

}  // namespace
}  // namespace desmo::linear_blocks_test
