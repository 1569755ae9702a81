// Steps that generated code refuses: none where a mechanism is far from a singular position.

#include <algorithm>
#include <vector>

#include "formulations/verification/condition.h"
#include "tests/formulated.h"
#include "tests/load/loading.h"

namespace desmo::load::refusals_test {
namespace {

/// Keeps the answers, and the largest condition number.
class Recorder final : public Observer {
 public:
  explicit Recorder(const Model& m) : condition_(m) {}

  Flow observe(const Instant& i) noexcept override {
    positions.insert(positions.end(), i.q.begin(), i.q.end());
    velocities.insert(velocities.end(), i.qd.begin(), i.qd.end());
    condition = std::max(condition, condition_(i.q));
    return Flow::go_on;
  }

  std::vector<double> positions, velocities;
  double condition = 0;

 private:
  ConditionNumber condition_;
};

struct Refusals : Loading {
  /// Solves the motion and returns the number of steps that generated code refused.
  long run(const std::string& id, const KernelTable& table, Recorder& recorder) {
    const Configuration c = parse_id(id);
    const auto f = make_formulation(*c.variant, model_, c.settings, table);
    const Summary s = f->run(scene_.grid, Request{Level::velocity}, recorder);
    EXPECT_TRUE(s.ok()) << id << ": " << describe(s, model_);
    return part_counts(*f).fallbacks;
  }

  /// Own code refuses no step, and its answers are right.
  void expect_none(const std::string& id) {
    KernelTable table;
    EXPECT_EQ(load(table, id).problem, "") << id;
    Recorder found(model_), expected(model_);
    EXPECT_EQ(run(id, table, found), 0) << id;
    EXPECT_LT(found.condition, 1e4) << id;
    run("group_automatic_eigen", table, expected);
    EXPECT_LT(max_relative_difference(found.positions, expected.positions), 1e-9) << id;
    EXPECT_LT(max_relative_difference(found.velocities, expected.velocities), 1e-8) << id;
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
