// Steps that generated code refuses: none where a mechanism is far from a singular position.

#include <span>

#include "formulations/verification/condition.h"
#include "tests/everything.h"
#include "tests/load/loading.h"

namespace desmo::load::refusals_test {
namespace {

struct Refusals : Loading {
  /// Own code refuses no step, and its answers are right.
  void expect_none(const std::string& id) {
    KernelTable table;
    const auto f = made(id, table), g = formulated("group_automatic_eigen", model_);
    const Request request{Level::velocity};
    Everything found(scene_.grid.instants), expected(scene_.grid.instants);
    ASSERT_TRUE(f->run(scene_.grid, request, found).ok()) << id;
    ASSERT_TRUE(g->run(scene_.grid, request, expected).ok());
    EXPECT_EQ(part_counts(*f).fallbacks, 0) << id;
    ConditionNumber condition(model_);
    const auto positions = [&](const Everything& motion, int i) {
      return std::span(motion.all[i]).first(model_.coordinates());
    };
    for (int i = 0; i < scene_.grid.instants; ++i) {
      EXPECT_LT(condition(positions(found, i)), 1e4) << id;
      EXPECT_LT(max_relative_difference(positions(found, i), positions(expected, i)), 1e-9) << id;
      EXPECT_LT(max_relative_difference(found.all[i], expected.all[i]), 1e-8) << id;
    }
  }
};

/// Every quarter of a turn a component of each cross vanishes, with the pivots that it is. The
/// program has kernels for these types of block, with pivots for other mechanisms, which refuse
/// half the steps.
TEST_F(Refusals, AreNoneWherePivotsVanishInTurn) {
  take("double_cardan_wrong_phase");
  for (const char* id : {"block_symbolic_inlined", "group_symbolic_inlined"}) expect_none(id);
}

/// The wheel's centre lies close to where a circle touches a line. From the last position the two
/// do not meet where the driver has gone.
TEST_F(Refusals, AreNoneWhereThePredictionHasNoClosedForm) {
  take("corner_bellcrank");
  expect_none("group_symbolic_explicit");
}

}  // namespace
}  // namespace desmo::load::refusals_test
