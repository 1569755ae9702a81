// Time against size: reader, growth, caches, crossings, figure.

#include "report/figures/figures.h"
#include "tests/report/size_sample.h"

namespace desmo::report::sizes_test {
namespace {

const std::string in_order = "group_symbolic_explicit", klu = "global_automatic_klu";

TEST(Sizes, OfWrongAnswersHaveNoTime) {
  Json json = sizes_record();
  Json& size = json["size"]["growth"][0];
  const auto read = [&] { return record_from(json).growth.at({"four_bar", 10, in_order}); };
  size["verification"]["velocity"] = 2e-8;
  EXPECT_EQ(read().status, Status::failed);
  EXPECT_EQ(read().message, "velocity differs by 2e-08, 1e-08 is allowed");
  EXPECT_TRUE(read().time.seconds.empty());
  // A larger tolerance allows larger differences.
  size["tolerance"] = 3 * json["record"]["settings"]["tolerance"].get<double>();
  EXPECT_EQ(read().status, Status::ok);
  size["verification"]["velocity"] = 4e-8;
  EXPECT_EQ(read().status, Status::failed);
}

TEST(Sizes, ThatSayNothingAreRefused) {
  expect_refusals(sizes_record(),
                  {{"/size/growth/0/status", "not_run", ": everything here is run"},
                   {"/size/growth/0/bytes", 0, ": "},
                   {"/size/break_even/2/unknowns", 0, ": "},
                   {"/size/break_even/0/id", "global_automatic_eigen",
                    "/size/break_even/1: four_bar/10/global_automatic_eigen is given twice"},
                   {"/size",
                    {{"growth", Json::array()}, {"break_even", Json::array()}},
                    "nothing was measured"}});
}

TEST(Growth, IsLinearUntilCachesEndIt) {
  const Section front = size_sections(record_from(sizes_record())).at(0);
  EXPECT_EQ(front.paragraphs.at(0),
            "Up to 10000 coordinates time grows linearly in 1 of 2 pairs of case and formulation.");
  EXPECT_EQ(front.numbers,
            (std::vector<std::string>{"linear growth: 1 of 2",
                                      "a coordinate of a step: 10.0 ns at the least",
                                      "sparse pays from 60 unknowns on, where times cross"}));
  const Table exponents = table_of(sizes_record(), "growth_exponents");
  const std::vector<std::string> row{"four_bar", in_order};
  EXPECT_EQ(entry_at(exponents, row, "slope").digits.back(), "4");  // 100 000 are not judged
  expect_row(exponents, row, {{"ns/coordinate, least", "10.0 …"}, {"times the least", "2.00"}});
  EXPECT_CONTAINS(entry_at(exponents, {"four_bar", klu}, "slope").note,
                  "not linear, a size FAILED");
}

TEST(BreakEven, IsInterpolatedBetweenItsNeighbours) {
  const Table table = table_of(sizes_record(), "break_even");
  expect_row(table, {"four_bar", "klu"},
             {{"lapack", "60 [30, 100]"},
              {"eigen", "42 [30, 100]"},
              {"the fastest dense", "60 [30, 100]"},
              {"the paper, about", "60"}});
  expect_row(table, {"four_bar", "umfpack"}, {{"lapack", "sparse from the smallest, 10"}});
  expect_row(table, {"four_bar", "cholmod"}, {{"lapack", "dense at the largest, 300"}});
  EXPECT_EQ(size_sections(record_from(sizes_record())).at(0).paragraphs.at(1),
            "Where times of a sparse and a dense solver cross, sparse matrices are faster from 60 "
            "unknowns on.");
}

TEST(BreakEven, OfCurvesThatCrossMoreThanOnceIsAllOfThese) {
  Json json = sizes_record();
  for (Json& entry : json["size"]["break_even"])
    if (entry["id"] == klu && entry["coordinates"] == 10)
      entry["time_per_step"]["seconds"] = {5e-7};  // noise: sparse is the faster here alone
  expect_row(table_of(json, "break_even"), {"four_bar", "klu"}, {{"lapack", "60 [10, 100]"}});
}

}  // namespace
}  // namespace desmo::report::sizes_test
