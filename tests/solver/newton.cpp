// Newton's method (Fig. 2b) and its choice of factors, on one equation whose solution everybody
// knows: Φ(x; h) = x² − h = 0.

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

#include "formulations/parts/newton_solver.h"

namespace desmo::newton_test {
namespace {

/// x² − h in a state (x, h). Notes each x at which Φ is evaluated.
class Square final : public Equations {
 public:
  explicit Square(std::vector<double>* tried = nullptr) : tried_(tried) {
    pattern_.n = 1;
    pattern_.unknowns = {0};
    pattern_.column_start = {0, 1};
    pattern_.row = {0};
    pattern_.known = {{.row = 0, .place = 1}};
  }
  const Pattern& pattern() const override { return pattern_; }
  void constant_jacobian(double* values) const override { values[1] = -1; }
  void residual(const double* state, double* phi) const override {
    if (tried_) tried_->push_back(state[0]);
    phi[0] = state[0] * state[0] - state[1];
  }
  void jacobian(const double* state, double* values) const override { values[0] = 2 * state[0]; }
  void known_jacobian(const double*, double*) const override {}
  void quadratic(const double*, const double* rate, double* gamma) const override {
    gamma[0] = 2 * rate[0] * rate[0];
  }

 private:
  Pattern pattern_;
  std::vector<double>* tried_;
};

/// Factors of a matrix of one entry. Counts them.
class OneEntry final : public LinearSolver {
 public:
  explicit OneEntry(int& factorisations) : count_(factorisations) {}
  bool factor(const double* values) override {
    ++count_;
    factor_ = values[0];
    return factor_ != 0;
  }
  void solve(double* b) override { *b /= factor_; }

 private:
  int& count_;
  double factor_ = 0;
};

class NewtonOfASquare : public testing::Test {
 protected:
  NewtonSolver solver(const PartSettings& settings) {
    return {std::make_unique<Square>(&tried_),
            one_,
            {},
            settings,
            std::make_unique<OneEntry>(factorisations_)};
  }
  PartSettings settings(JacobianUpdate update = JacobianUpdate::newton) const {
    return PartSettings(Settings{.tolerance = 1e-12, .max_iterations = 25, .jacobian = update});
  }
  PartResult solve(NewtonSolver& newton, double h, Level level = Level::acceleration) {
    state_.q[1] = h;
    return newton.solve(state_, {}, level);
  }

  const std::vector<double> one_{1};
  int factorisations_ = 0;
  std::vector<double> tried_;
  State state_{{1.5, 0}, {0, 4}, {0, 3}};  // of x and h
};

TEST_F(NewtonOfASquare, FindsPositionVelocityAndAcceleration) {
  auto newton = solver(settings());
  const PartResult r = solve(newton, 2);
  ASSERT_EQ(r.status, Status::solved);
  const double x = std::sqrt(2.0), v = 4 / (2 * x);  // 2xẋ = ḣ, 2xẍ + 2ẋ² = ḧ
  EXPECT_NEAR(state_.q[0], x, 1e-15);
  EXPECT_NEAR(state_.qd[0], v, 1e-15);
  EXPECT_NEAR(state_.qdd[0], (3 - 2 * v * v) / (2 * x), 1e-15);
  EXPECT_EQ(r.iterations, 4);
  EXPECT_EQ(factorisations_, r.iterations + 1);  // the last one serves both rates
}

TEST_F(NewtonOfASquare, LeavesRatesAloneAtTheLevelOfPositions) {
  auto newton = solver(settings());
  ASSERT_EQ(solve(newton, 2, Level::position).status, Status::solved);
  EXPECT_EQ(factorisations_, 4);
  EXPECT_EQ(state_.qd[0], 0);
}

TEST_F(NewtonOfASquare, CorrectsOnceMoreAtRounding) {
  PartSettings s = settings();
  s.at_rounding = true;
  auto newton = solver(s);
  EXPECT_EQ(solve(newton, 2).iterations, 5);
}

TEST_F(NewtonOfASquare, SaysWhyItFails) {
  auto newton = solver(settings());
  EXPECT_EQ(solve(newton, -1).status, Status::not_converged);
  state_.q[0] = 0;
  EXPECT_EQ(solve(newton, 1).status, Status::singular);
  EXPECT_EQ(solve(newton, NAN).status, Status::not_finite);
}

/// The factors of the last position serve the next step, which makes its own where it ends.
TEST_F(NewtonOfASquare, FactorisesOnceAStep) {
  auto newton = solver(settings(JacobianUpdate::step));
  ASSERT_EQ(solve(newton, 2).status, Status::solved);
  for (int i = 1; i <= 5; ++i) {
    const int before = factorisations_;
    ASSERT_EQ(solve(newton, 2 + 1e-3 * i).status, Status::solved);
    EXPECT_NEAR(state_.q[0], std::sqrt(2 + 1e-3 * i), 1e-12);
    EXPECT_EQ(factorisations_, before + 1);
  }
}

/// Old factors of 0.02 send x to 50 from 0.01, where Φ is larger: the step goes on from 0.01.
TEST_F(NewtonOfASquare, TakesBackACorrectionThatLedAway) {
  auto newton = solver(settings(JacobianUpdate::step));
  state_.q[0] = 0.011;
  ASSERT_EQ(solve(newton, 1e-4).status, Status::solved);
  tried_.clear();
  ASSERT_EQ(solve(newton, 1).status, Status::solved);
  EXPECT_NEAR(state_.q[0], 1, 1e-12);
  ASSERT_GT(tried_.size(), 3u);
  EXPECT_NEAR(tried_[1], 50, 0.1);
  EXPECT_NEAR(tried_[2], tried_[0], 1e-13);
}

}  // namespace
}  // namespace desmo::newton_test
