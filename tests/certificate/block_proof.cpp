// Batches of blocks against quadruple precision, where their lanes share pivots that suit none.

#include "formulations/verification/certificate/block_proof.h"

#include <gtest/gtest.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <boost/multiprecision/float128.hpp>
#include <random>

#include "formulations/constraints/constraints.h"

namespace desmo::block_proof_test {
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
  BlockBatch::Member made{{}, 0, k, 2 * k, Level::acceleration, {2 * k, 2 * k + 1}};
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

/// Returns tables of so many rows.
PerLevel<ErrorTable> tables_of(int rows) {
  PerLevel<ErrorTable> errors;
  for (const Level level : all_levels) errors[level].rows.resize(rows);
  return errors;
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

/// An equation u·v = c, of which only the first component of u is unknown.
BlockBatch::Member product_of_vectors(double c) {
  BlockBatch::Member made{{}, 0, 0, 0, Level::acceleration, {0, 1, 2, 3, 4, 5}};
  BlockShape& s = made.block.shape;
  s.unknowns = 1;
  s.inputs = 5;
  s.linear = false;
  s.columns = s.entries = s.column_entries = made.rows;
  s.column_rows = {0, 0, 0, 0, 0, 0};
  s.row_begins = {0, 6};
  s.input_begins = {1};
  s.column_begins = {0, 1, 2, 3, 4, 5, 6};
  s.objects.push_back({kind_index<Dot<3>>(), {0, 3}, {0, -1, -1}, 0, {0, 3, 1, 4, 2, 5}});
  made.block.states = made.block.coordinates = made.rows;
  made.block.constants = {c};
  return made;
}

/// Errors of positions that cancel each other in a rate, but for what rounding loses.
TEST(BlockProof, CountsRoundingOfWhatLowerLevelsAdd) {
  using Exact = boost::multiprecision::cpp_rational;
  constexpr double s = 0x1p-20, lost = 0x1.fp-54 * s;  // less than half of the last place of s
  const std::array<double, 6> delivered{0.25, 0, 0, 1, -1, 0}, error{0, s, lost, lost, lost, -s},
      rates{1, 1, 1, 0, 1, 1};
  BlockBatch batch(std::vector{product_of_vectors(0.25)}, std::vector<double>(6, 1), 0);
  PerLevel<ErrorTable> errors = tables_of(6);
  std::array<Exact, 6> exact;
  for (int i = 0; i < 6; ++i) {
    errors.position.rows[i] = {delivered[i], error[i], 0, std::abs(error[i])};
    errors.velocity.rows[i].delivered = rates[i];
    exact[i] = Exact(delivered[i]) + Exact(error[i]);
  }
  BlockProof proof({.unknowns = 1, .width = 6, .states = 6, .columns = 0});
  ASSERT_TRUE(proof.prove(batch, Level::velocity, errors).velocity[0]);
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
    BlockBatch batch(std::vector{product_of_vectors(1)}, std::vector<double>(6, 1), 0);
    PerLevel<ErrorTable> errors = tables_of(6);
    for (int i = 0; i < 6; ++i) {
      errors.position.rows[i].delivered = delivered[i];
      errors.velocity.rows[i].delivered = rates[i];
    }
    const double off = percent / 100.0;
    errors.position.rows[3] = {1, 0, off, off};
    BlockProof proof({.unknowns = 1, .width = 6, .states = 6, .columns = 0});
    if (!proof.prove(batch, Level::velocity, errors).velocity[0]) continue;
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
  BlockBatch::Member member = product_of_vectors(1);
  member.block.slack = {slack};
  BlockBatch batch(std::vector{member}, std::vector<double>(6, 1), 0);
  PerLevel<ErrorTable> errors = tables_of(6);
  errors.position.rows[0].delivered = 2;
  errors.position.rows[3].delivered = 0.5;
  BlockProof proof({.unknowns = 1, .width = 6, .states = 6, .columns = 0});
  ASSERT_TRUE(proof.prove(batch, Level::position, errors).position[0]);
  EXPECT_LE(2 * slack, errors.position.rows[0].sum);
  EXPECT_LE(errors.position.rows[0].sum, 2.01 * slack);
}

/// A lane that is proven at once keeps its X while another lane needs a larger one.
TEST(BlockProof, KeepsWhatIsProvenInOneLane) {
  constexpr double small = 0x1p-40, off = 0.3;
  const std::array<double, 2> products{small, 1}, delivered{small, 1.001};
  std::array<double, 2> radius;
  for (const int lanes : {1, 2}) {
    std::vector<BlockBatch::Member> members;
    for (int k = 0; k < lanes; ++k) {
      BlockBatch::Member& made = members.emplace_back(product_of_vectors(products[k]));
      for (int& row : made.rows) row += 6 * k;
      made.block.states = made.block.coordinates = made.rows;
    }
    BlockBatch batch(members, std::vector<double>(12, 1), 0);
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

/// An input that is uncertain at two levels, in a link of a chain: by symbols, or in a box. What
/// the block hands on holds for each choice within both, with the symbols and without them.
TEST(BlockProof, HandsErrorsOn) {
  using Exact = boost::multiprecision::cpp_rational;
  constexpr int rows = 6, columns = 2;
  constexpr double off = 1e-3;
  const PerLevel<std::array<double, 2>> delivered{{1, 1}, {1, -1}, {2, 0}};  // of u₁ and v₁
  for (const bool boxed : {false, true}) {
    BlockBatch::Member member = product_of_vectors(1);
    for (int& row : member.rows) row += rows;
    BlockBatch batch(std::vector{member}, std::vector<double>(rows, 1), columns);
    PerLevel<ErrorTable> errors = tables_of(2 * rows);
    for (const Level level : all_levels) {
      ErrorTable& e = errors[level];
      e.generators.resize(rows * columns);
      e.columns = columns;
      e.first_lent = rows;
      for (const int first : {0, rows}) {
        e.rows[first].delivered = delivered[level][0];
        e.rows[first + 3].delivered = delivered[level][1];
      }
      if (level == Level::acceleration) continue;
      (boxed ? e.rows[rows + 3].own : e.of_row(rows + 3)[static_cast<int>(level)]) = off;
      e.rows[rows + 3].sum = off;
    }
    BlockProof proof({.unknowns = 1, .width = rows, .states = rows, .columns = columns});
    ASSERT_TRUE(proof.prove(batch, Level::acceleration, errors).acceleration[0]);
    PerLevel<Exact> largest;
    for (int corner = 0; corner < 4; ++corner) {
      const std::array<int, 2> t{corner & 1 ? 1 : -1, corner & 2 ? 1 : -1};
      const Exact v = 1 + Exact(off) * t[0], rate_of_v = -1 + Exact(off) * t[1];
      const Exact u = 1 / v, rate = -u * rate_of_v / v;
      const PerLevel<Exact> exact{u, rate, -2 * rate * rate_of_v / v};
      for (const Level level : all_levels) {
        const ErrorTable& e = errors[level];
        const ErrorTable::Row& row = e.rows[rows];
        const Exact error = exact[level] - Exact(row.delivered);
        EXPECT_LE(abs(error), Exact(row.sum)) << corner;
        EXPECT_LE(abs(error), Exact(e.rows[0].sum)) << corner;
        EXPECT_LE(abs(error - Exact(row.centre)), Exact(e.rows[0].own)) << corner;
        Exact rest = error - Exact(row.centre);
        for (int k = 0; k < columns; ++k) rest -= Exact(e.of_row(rows)[k]) * t[k];
        EXPECT_LE(abs(rest), Exact(row.own)) << corner;
        if (abs(error) > largest[level]) largest[level] = abs(error);
      }
    }
    for (const Level level : all_levels)
      EXPECT_LE(Exact(errors[level].rows[0].sum), largest[level] * Exact(1.01));
  }
}

/// An input with few large symbols and many small ones, which are lost when magnitudes are added.
TEST(BlockProof, CountsRoundingOfManySymbols) {
  using Exact = boost::multiprecision::cpp_rational;
  constexpr int rows = 6, columns = 16'000, large = 16, input = 1;
  BlockBatch::Member member = product_of_vectors(0);  // u₁ + u₂ = 0
  for (int& row : member.rows) row += rows;
  BlockBatch batch(std::vector{member}, std::vector<double>(rows, 1), columns);
  PerLevel<ErrorTable> errors = tables_of(2 * rows);
  ErrorTable& e = errors.position;
  e.generators.resize(rows * columns);
  e.columns = columns;
  e.first_lent = rows;
  for (const int v : {3, 4}) e.rows[v].delivered = e.rows[rows + v].delivered = 1;
  const std::span symbols(e.of_row(rows + input), columns);
  constexpr double lost = 0x1.fp-52;  // even where four or eight sums are added at once
  std::ranges::fill(symbols, lost);
  std::ranges::fill(symbols.first(large), 1);
  e.rows[rows + input].set_error(0, symbols);
  BlockProof proof({.unknowns = 1, .width = rows, .states = rows, .columns = columns});
  ASSERT_TRUE(proof.prove(batch, Level::position, errors).position[0]);
  EXPECT_LE(large + (columns - large) * Exact(lost), Exact(e.rows[0].sum));
  EXPECT_LE(e.rows[0].sum, large * (1 + 1e-9));
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

/// The driven component of v is off, or not known, by 0.6, which is too much, or x is off by more
/// than that.
TEST(BlockProof, SaysWhatMostOfAnErrorComesFrom) {
  const auto failure = [](double off, double unknown, double product) {
    BlockBatch batch(std::vector{product_of_vectors(product)}, std::vector<double>(6, 1), 0);
    PerLevel<ErrorTable> errors = tables_of(6);
    ErrorTable& e = errors.position;
    for (auto* values : {&e.radius, &e.correction, &e.rest}) values->resize(6);
    e.rows[0].delivered = 1;
    e.rows[3] = {1, off, unknown, off + unknown};
    BlockProof proof({.unknowns = 1, .width = 6, .states = 6, .columns = 0});
    EXPECT_FALSE(proof.prove(batch, Level::position, errors).position[0]);
    return proof.failure(0);
  };
  EXPECT_EQ(failure(0.6, 0, 1), ProofFailure::drivers);
  EXPECT_EQ(failure(0, 0.6, 1), ProofFailure::time);
  EXPECT_EQ(failure(0, 0.6, 4), ProofFailure::far_off);  // 0.6 of 3.6
}

}  // namespace
}  // namespace desmo::block_proof_test
