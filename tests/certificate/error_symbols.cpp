// Errors that blocks of a long chain hand on by symbols, in exact arithmetic.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <boost/multiprecision/cpp_int.hpp>
#include <span>

#include "tests/certificate/product_block.h"

namespace desmo::error_symbols_test {
namespace {

using Exact = boost::multiprecision::cpp_rational;

/// An input that is uncertain at two levels, in a link of a chain: by symbols, or in a box. What
/// the block hands on holds for each choice within both, with the symbols and without them.
TEST(BlockProof, HandsErrorsOn) {
  constexpr int rows = ProductBlock::rows, columns = 2;
  constexpr double off = 1e-3;
  const PerLevel<std::array<double, 2>> delivered{{1, 1}, {1, -1}, {2, 0}};  // of u₁ and v₁
  for (const bool boxed : {false, true}) {
    ProductBlock block(1, columns);
    PerLevel<ErrorTable>& errors = block.errors;
    for (const Level level : all_levels) {
      ErrorTable& e = errors[level];
      for (const int first : {0, rows}) {
        e.rows[first].delivered = delivered[level][0];
        e.rows[first + 3].delivered = delivered[level][1];
      }
      if (level == Level::acceleration) continue;
      (boxed ? e.rows[rows + 3].own : e.of_row(rows + 3)[static_cast<int>(level)]) = off;
      e.rows[rows + 3].sum = off;
    }
    ASSERT_TRUE(block.prove(Level::acceleration));
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
  constexpr int rows = ProductBlock::rows, columns = 16'000, large = 16, input = 1;
  ProductBlock block(0, columns);  // u₁ + u₂ = 0
  ErrorTable& e = block.errors.position;
  for (const int v : {3, 4}) e.rows[v].delivered = e.rows[rows + v].delivered = 1;
  const std::span symbols(e.of_row(rows + input), columns);
  constexpr double lost = 0x1.fp-52;  // even where four or eight sums are added at once
  std::ranges::fill(symbols, lost);
  std::ranges::fill(symbols.first(large), 1);
  e.rows[rows + input].set_error(0, symbols);
  ASSERT_TRUE(block.prove(Level::position));
  EXPECT_LE(large + (columns - large) * Exact(lost), Exact(e.rows[0].sum));
  EXPECT_LE(e.rows[0].sum, large * (1 + 1e-9));
}

}  // namespace
}  // namespace desmo::error_symbols_test
