// Errors that a group of a chain hands to the next: of two coordinates at two levels, in one basis.

#include "formulations/verification/certificate/group_interface.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <tuple>

namespace desmo::group_interface_test {
namespace {

constexpr int size = 2, columns = 2, first_lent = size;
constexpr std::array solved{Level::position, Level::velocity};
/// Errors of rows 2 and 3 at both levels: centres, G and own radii.
constexpr double centre[2][size] = {{1, -2}, {3, -4}};
constexpr double g[2][size][columns] = {{{0.5, 0.1}, {-0.2, 0.3}}, {{0.7, -0.4}, {0.1, 0.6}}};
constexpr double own[2][size] = {{0.25, 0.125}, {0.5, 0.0625}};

double width(int level, int i) {
  return std::abs(g[level][i][0]) + std::abs(g[level][i][1]) + own[level][i];
}

GroupInterface interface_of_two() {
  GroupInterface made{{0, 1},
                      {first_lent, first_lent + 1},
                      {static_cast<int>(all_levels.size()) * size, columns},
                      {}};
  for (const Level level : all_levels) made.centre[level].resize(size);
  return made;
}

PerLevel<ErrorTable> errors_of_two() {
  PerLevel<ErrorTable> errors;
  for (const Level level : solved) {
    ErrorTable& e = errors[level];
    const int l = static_cast<int>(level);
    e.rows.resize(first_lent + size);
    e.columns = columns;
    e.first_lent = first_lent;
    e.generators.resize(size * columns);
    for (int i = 0; i < size; ++i) {
      e.rows[first_lent + i] = {9, centre[l][i], own[l][i], std::abs(centre[l][i]) + width(l, i)};
      for (int k = 0; k < columns; ++k) e.of_row(first_lent + i)[k] = g[l][i][k];
    }
  }
  return errors;
}

/// A table of the next group, with symbols of two interfaces, and other numbers left in all rows.
ErrorTable table_of_next() {
  ErrorTable table;
  table.first_lent = size;
  table.columns = 10;
  table.rows.resize(size + size);
  table.rows[0] = {5, 6, 7, 13};
  table.rows[1] = {15, 16, 17, 33};
  table.generators.assign(size * table.columns, 99);
  return table;
}

TEST(GroupInterface, HandsOnWhatItsBasisEncloses) {
  GroupInterface interface = interface_of_two();
  interface.enclose(solved, errors_of_two());
  ASSERT_TRUE(interface.enclosed);
  ASSERT_EQ(interface.basis.size(), 4);
  for (const Level level : solved) {
    const int l = static_cast<int>(level);
    ErrorTable table = table_of_next();
    constexpr int first = 3;
    interface.lend(level, size, first, table);
    for (int i = 0; i < size; ++i) {
      const ErrorTable::Row& row = table.rows[size + i];
      EXPECT_EQ(row.delivered, table.rows[i].delivered);
      EXPECT_EQ(row.centre, centre[l][i]);
      EXPECT_EQ(row.own, 0);
      double sum = 0;
      for (int k = 0; k < table.columns; ++k) {
        const bool is_its = k >= first && k < first + 4;
        const double symbol = table.of_row(size + i)[k];
        EXPECT_EQ(symbol, is_its ? interface.basis.generator(2 * l + i, k - first) : 0);
        sum += std::abs(symbol);
      }
      EXPECT_GE(sum, width(l, i));
      EXPECT_LE(sum, 2.5 * width(l, i));
      EXPECT_NEAR(row.sum, std::abs(row.centre) + sum, 1e-14);
    }
  }
}

TEST(GroupInterface, HandsRadiiOnWhereOneIsNotBounded) {
  for (const Level level : solved) {
    GroupInterface interface = interface_of_two();
    PerLevel<ErrorTable> errors = errors_of_two();
    errors[level].rows[first_lent + 1].sum = INFINITY;
    interface.enclose(solved, errors);
    EXPECT_FALSE(interface.enclosed);
    ErrorTable table = table_of_next();
    interface.lend(Level::position, size, 3, table);
    for (int i = 0; i < size; ++i) {
      const ErrorTable::Row &lent = table.rows[size + i], &box = table.rows[i];
      EXPECT_EQ(std::tie(lent.delivered, lent.centre, lent.own, lent.sum),
                std::tie(box.delivered, box.centre, box.own, box.sum));
      for (int k = 0; k < table.columns; ++k) EXPECT_EQ(table.of_row(size + i)[k], 0);
    }
  }
}

}  // namespace
}  // namespace desmo::group_interface_test
