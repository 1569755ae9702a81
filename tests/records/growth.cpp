// Analysis and solution of generated mechanism files grow near linearly with the number of bodies.

#include <gtest/gtest.h>

#include <cstdio>
#include <sstream>
#include <string>

namespace desmo::growth_test {
namespace {

struct Row {
  std::string name;
  double bodies, coordinates, blocks, size, read, model, cut, setup, step;
  double analysis() const { return read + model + cut; }
};

TEST(FileGrowth, IsNearLinearUpToTenThousandBodies) {
  FILE* pipe = popen(DESMO_BENCH " size --files", "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  for (int c; (c = std::fgetc(pipe)) != EOF;) output += static_cast<char>(c);
  ASSERT_EQ(pclose(pipe), 0);
  std::cout << output;

  std::istringstream lines(output);
  std::string header;
  std::getline(lines, header);
  std::vector<Row> rows;
  for (Row r; lines >> r.name >> r.bodies >> r.coordinates >> r.blocks >> r.size >> r.read >>
              r.model >> r.cut >> r.setup >> r.step;)
    rows.push_back(r);
  ASSERT_EQ(rows.size(), 6u);
  for (const std::size_t last : {2u, 5u}) {
    EXPECT_GT(rows[last].bodies, 9'900);
    // Ten times the bodies: a quadratic cost would show as 100. The bound leaves room for a cache
    // that no longer holds everything and for a neighbour that shares it.
    EXPECT_LT(rows[last].analysis(), 40 * rows[last - 1].analysis()) << rows[last].name;
    EXPECT_LT(rows[last].step, 40 * rows[last - 1].step) << rows[last].name;
  }
}

}  // namespace
}  // namespace desmo::growth_test
