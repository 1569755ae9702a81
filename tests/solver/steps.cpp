// Lengths of the steps that lead from one instant to another, whatever solves them.

#include <gtest/gtest.h>

#include <numbers>
#include <span>
#include <vector>

#include "cases/mechanism/builder.h"
#include "formulations/modelling/modelling.h"
#include "formulations/motion/driver_continuation.h"
#include "formulations/motion/internals.h"
#include "formulations/motion/prediction/driver_source.h"
#include "formulations/motion/sub_steps.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::steps_test {
namespace {

/// A motion that needs sub-steps of a 300th is led on. One that needs those of a 3000th is given
/// up: it would take as many.
TEST(SubSteps, AreHalvedToAThousandth) {
  for (const double longest : {1. / 300, 1. / 3000}) {
    double reached = 0;
    const auto go = [&](double t) {
      const bool solved = t - reached <= longest;
      if (solved) reached = t;
      return solved;
    };
    EXPECT_EQ(go_in_sub_steps(0, 1, 100'000, go), longest > 1e-3);
    EXPECT_EQ(reached == 1, longest > 1e-3);
  }
}

/// A motion is entered in its middle, from a position of another instant. So far away one try is
/// not enough, with so few iterations.
TEST(SubSteps, GoOnFromAContinuedStart) {
  constexpr double entered = 0.5, later = 1.5;  // s
  const Model m = four_bar_model(3);
  for (const char* id :
       {"global_automatic_klu", "group_automatic_lapack", "group_symbolic_inlined"}) {
    const auto walked = formulated(id, m), f = formulated(id, m, {.max_iterations = 3});
    ASSERT_TRUE(walked->assemble(0).ok());
    const std::vector<double> start(walked->q().begin(), walked->q().end());
    for (int i = 1; i <= 150; ++i) ASSERT_TRUE(walked->step(0.01 * i).ok());
    ASSERT_TRUE(stepping_of(*f).start_at(start, entered)) << id;
    const Summary step = f->step(later);
    ASSERT_TRUE(step.ok()) << id;
    EXPECT_GT(step.sub_steps, 0) << id;
    EXPECT_LT(max_difference(f->q(), walked->q()), 1e-9) << id;
  }
}

/// Follows a driver by a continuation to another angle. longest: share of the way that a step can
/// be solved of.
struct Followed {
  Followed(const Model& m, double longest) {
    const int driver = m.entities[m.drivers[0].coordinate].first;
    const std::vector<double> zeros(m.state_size());
    State state{m.state_of(m.estimate), zeros, zeros};
    State target = state;
    write_drivers(m, 0, target);
    const double way = target.q[driver] - state.q[driver];
    end = continue_drivers_to(m, target, state, [&](State& to, std::span<const double> last) {
      const double share = (to.q[driver] - last[driver]) / way;
      if (share > longest) return false;
      ++steps;
      return true;
    });
  }

  ContinuationEnd end;
  int steps = -1;  // it is solved where it is, too
};

/// Half a turn at once may lead to another branch, 80 steps are ten times the price. What takes
/// steps of a 60th of the way is led on, what takes those of a 400th is not.
TEST(Continuation, TakesEightStepsAndHalvesThemFourTimes) {
  Model m = four_bar_model(1);
  const double start = m.estimate[m.entities[m.drivers[0].coordinate].first];
  m.drivers[0].motion = Polynomial{{start + 3}};
  const Followed easy(m, 1);
  EXPECT_EQ(easy.end, ContinuationEnd::reached);
  EXPECT_GE(easy.steps, 4);
  EXPECT_LE(easy.steps, 16);
  EXPECT_EQ(Followed(m, 1. / 60).end, ContinuationEnd::reached);
  EXPECT_EQ(Followed(m, 1. / 400).end, ContinuationEnd::blocked);
}

/// Turns count where angles are coupled: a step of 0.3 rad may lead to another branch, and one of
/// 0.03 rad takes three times as long.
TEST(Continuation, TurnsCoupledAnglesByATenthOfARadian) {
  MechanismBuilder builder("gears", 2);
  for (const int k : {0, 1}) {
    const std::string name = std::to_string(k);
    const int a = builder.point("A" + name, {3. * k, 0, 0}),
              b = builder.point("B" + name, {3. * k + 1, 0, 0});
    builder.carry(MechanismBuilder::ground, {a});
    const int gear = builder.body("gear" + name, {a, b});
    builder.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, gear, {a});
    builder.angle("t" + name, {-1, a, b}).driven = k == 0;
  }
  builder.couple("mesh", {{0, 1}, {1, 1}});
  const double way = 3 * 2 * std::numbers::pi;
  const Model m = model_mechanism(builder.release(), {Polynomial{{way}}}).model;
  const Followed followed(m, 1);
  EXPECT_EQ(followed.end, ContinuationEnd::reached);
  EXPECT_LE(way / followed.steps, 0.3);
  EXPECT_GE(way / followed.steps, 0.03);
}

}  // namespace
}  // namespace desmo::steps_test
