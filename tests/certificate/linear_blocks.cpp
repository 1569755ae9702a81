// Rounding in the proof of linear blocks, in exact arithmetic. All their equations are homogeneous,
// so where nothing else moves, what is delivered is the error.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <random>
#include <vector>

#include "formulations/constraints/constraints.h"
#include "formulations/verification/certificate/block_proof.h"

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
  Block(int unknowns, int inputs, const std::vector<Equation>& equations)
      : unknowns_(dimensions * unknowns), width_(dimensions * (unknowns + inputs)) {
    BlockBatch::Member made{{}, 0, 0, 0, Level::acceleration, {}};
    BlockShape& s = made.block.shape;
    s.unknowns = unknowns_;
    s.inputs = width_ - unknowns_;
    for (int j = 0; j < width_; ++j) {
      s.columns.push_back(j);
      made.rows.push_back(j);
    }
    made.block.states = made.block.coordinates = made.rows;
    add_rows(s, equations);
    for (const Equation& equation : equations)
      made.block.constants.insert(made.block.constants.end(), equation.c.begin(), equation.c.end());
    batch_.emplace(std::vector{made}, std::vector<double>(width_, 1), 0);
    errors_.position.rows.resize(width_);
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
  bool prove() {
    BlockProof proof({.unknowns = unknowns_, .width = width_, .states = width_, .columns = 0});
    return proof.prove(*batch_, Level::position, errors_).position[0];
  }
  double radius(int point) const { return errors_.position.rows[dimensions * point].sum; }

 private:
  static void add_rows(BlockShape& s, const std::vector<Equation>& equations) {
    s.row_begins = {0};
    std::vector<std::vector<std::array<int, 2>>> by_column(s.width());
    int row = 0;
    for (const Equation& e : equations) {
      BlockShape::Object o{kind_index<Kind>(),
                           {},
                           {row, row + 1, row + 2},
                           static_cast<int>(summands * s.objects.size()),
                           {}};
      for (int k = 0; k <= summands; ++k) o.operands[k] = dimensions * e.points[k];
      for (int i = 0; i < dimensions; ++i, ++row) {
        std::array<int, summands + 1> sorted = e.points;
        std::ranges::sort(sorted);
        const int begin = s.row_begins.back();
        int inputs_begin = begin + summands + 1;
        for (int k = 0; k <= summands; ++k) {
          const int column = dimensions * sorted[k] + i;
          if (column >= s.unknowns) inputs_begin = std::min(inputs_begin, begin + k);
          by_column[column].push_back({row, begin + k});
          s.entries.push_back(column);
        }
        for (const int point : e.points)
          o.slots.push_back(begin +
                            static_cast<int>(std::ranges::find(sorted, point) - sorted.begin()));
        s.row_begins.push_back(begin + summands + 1);
        s.input_begins.push_back(inputs_begin);
      }
      s.objects.push_back(o);
    }
    s.column_begins = {0};
    for (const auto& column : by_column) {
      for (const auto& [of_row, entry] : column) {
        s.column_rows.push_back(of_row);
        s.column_entries.push_back(entry);
      }
      s.column_begins.push_back(static_cast<int>(s.column_rows.size()));
    }
  }

  int unknowns_, width_;
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
