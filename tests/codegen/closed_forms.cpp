// The rules of explicit orders, at random sample points where the unknowns are known: a closed form
// must give them back, and rates that the equations, differentiated, agree with.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "formulations/base/per_level.h"
#include "formulations/codegen/closed_forms/sphere_and_planes.h"
#include "formulations/codegen/order/closed_form.h"
#include "formulations/codegen/order/tearing.h"
#include "formulations/codegen/record/expression.h"

namespace desmo::generate::closed_forms_test {
namespace {

constexpr int samples = 6;

class ClosedForms : public testing::TestWithParam<unsigned> {
 protected:
  Graph graph{samples};
  std::mt19937 random{GetParam()};
  Facts facts;

  /// An input that has value(s) at sample s.
  Expr input_of(const auto& value) {
    std::vector<double> values;
    for (int s = 0; s < samples; ++s) values.push_back(value(s));
    return Expr::node(graph.input("x", values));
  }
  Expr input(double low = -1, double high = 1) {
    std::uniform_real_distribution<double> uniform(low, high);
    return input_of([&](int) { return uniform(random); });
  }
  std::vector<Expr> inputs(int n) {
    std::vector<Expr> result;
    for (int i = 0; i < n; ++i) result.push_back(input());
    return result;
  }
  /// An input that has the value of e: a dimension that makes an equation hold.
  Expr dimension(Expr e) { return Expr::node(graph.input("c", e.samples(), false)); }

  /// Gives an unknown random rates.
  void move(Rates& rates, Expr x) {
    for (const Level level : rate_levels) rates.set(level, x, input());
  }

  static void expect_equal(Expr a, Expr b, double tolerance = 1e-9) {
    for (int s = 0; s < samples; ++s)
      EXPECT_NEAR(a.samples()[s], b.samples()[s], tolerance * (1 + std::abs(b.samples()[s])));
  }

  /// The rule gives the unknowns, and rates with which the equations go on to hold.
  void expect_solved(const Task& task, const std::string& rule) {
    const std::optional<ClosedForm> form = solve_closed(task);
    ASSERT_TRUE(form);
    EXPECT_EQ(form->rule, rule);
    for (std::size_t i = 0; i < form->values.size(); ++i) expect_equal(form->values[i], task.x[i]);
    for (const SizeMonitor& m : form->monitors.sizes)
      for (int s = 0; s < samples; ++s)
        EXPECT_GT(m.value.samples()[s], m.bound * m.against.samples()[s]);

    Rates rates;
    for (const Expr e : task.equations)
      for (const Expr i : moving_inputs(e)) move(rates, i);
    for (const Expr x : task.x)
      for (const Level level : rate_levels) rates.set(level, x, 0);
    double largest = 1;  // near-singular samples have large rates, whose terms cancel
    for (const Level level : rate_levels) {
      const std::vector<Expr> found = form->rates(rates, level);
      for (std::size_t i = 0; i < found.size(); ++i) {
        rates.set(level, task.x[i], found[i]);
        for (const double v : found[i].samples()) largest = std::max(largest, std::abs(v));
      }
    }
    for (const Expr e : task.equations) {
      expect_equal(rates.of(Level::velocity, e), 0, 1e-11 * largest);
      expect_equal(rates.of(Level::acceleration, e), 0, 1e-9 * largest);
    }
  }
};

std::vector<Expr> minus(const std::vector<Expr>& a, const std::vector<Expr>& b) {
  std::vector<Expr> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(a[i] - b[i]);
  return d;
}

TEST_P(ClosedForms, SpheresAndPlanesOfEveryNumber) {
  const char* const rules[3][3] = {{"square root"},
                                   {"circle and line", "two circles"},
                                   {"sphere and planes", "sphere and planes", "three spheres"}};
  for (int n = 1; n <= 3; ++n)
    for (int spheres = 1; spheres <= n; ++spheres) {
      Task task{inputs(n), {}, facts};
      for (int k = 0; k < spheres; ++k) {
        const auto d = minus(task.x, inputs(n));
        task.equations.push_back(dot(d, d) - dimension(dot(d, d)));
      }
      for (int k = spheres; k < n; ++k) {
        const auto a = inputs(n), d = minus(task.x, inputs(n));
        task.equations.push_back(dot(a, d) - dimension(dot(a, d)));
      }
      expect_solved(task, rules[n - 1][spheres - 1]);
    }
}

TEST_P(ClosedForms, KnownProductsChangeNothing) {
  Task task{inputs(3), {}, facts};
  const auto a = inputs(3), b = inputs(3);
  facts.learn(dot(a, a) - dimension(dot(a, a)));
  facts.learn(dot(b, b) - dimension(dot(b, b)));
  facts.learn(dot(a, b) - dimension(dot(a, b)));
  task.equations = {dot(a, task.x) - dimension(dot(a, task.x)),
                    dot(b, task.x) - dimension(dot(b, task.x)),
                    dot(task.x, task.x) - dimension(dot(task.x, task.x))};
  const std::optional<ClosedForm> form = solve_closed(task);
  ASSERT_TRUE(form);
  for (int i = 0; i < 3; ++i) expect_equal(form->values[i], task.x[i]);
}

TEST_P(ClosedForms, LinearSystems) {
  for (int n = 1; n <= 3; ++n) {
    Task task{inputs(n), {}, facts};
    for (int r = 0; r < n; ++r) {
      auto a = inputs(n);
      a[r] = a[r] + 3;
      task.equations.push_back(dot(a, task.x) - dimension(dot(a, task.x)));
    }
    expect_solved(task, "linear");
  }
}

TEST_P(ClosedForms, DirectionAndLength) {
  for (int n = 2; n <= 3; ++n) {
    auto d = inputs(n);
    const Expr s = input(0.5, 2);
    std::vector<Expr> x = d;
    x.push_back(s);
    Task task{x, {}, facts};
    for (int i = 0; i < n; ++i) {
      // b − a = s d at every sample
      const Expr a = input(), b = input_of([&](int k) {
                                return a.samples()[k] + s.samples()[k] * d[i].samples()[k];
                              });
      task.equations.push_back(b - a - s * d[i]);
    }
    task.equations.push_back(dot(d, d) - dimension(dot(d, d)));
    expect_solved(task, "direction and length");
  }
}

TEST_P(ClosedForms, AnglesModuloHalfATurn) {
  const Expr theta = input(-3, 3), a = input(0.2, 1),
             b = input_of([&](int s) { return -a.samples()[s] / std::tan(theta.samples()[s]); });
  const Task task{{theta}, {a * cos(theta) + b * sin(theta)}, facts};
  const std::optional<ClosedForm> form = solve_closed(task);
  ASSERT_TRUE(form && form->bearing);
  for (int s = 0; s < samples; ++s)
    EXPECT_NEAR(std::atan2(form->bearing->y.samples()[s], form->bearing->x.samples()[s]),
                theta.samples()[s], 1e-9);
  expect_solved(task, "angle modulo half a turn");
}

/// Unit vectors normal to the same two, on this side or that: known but for their sign.
TEST_P(ClosedForms, AreWrittenByEarlierOnesOfWhichTheyAreOppositesOrEquals) {
  const auto a = inputs(3), b = inputs(3), c = inputs(3);
  const auto normal = [&](const std::vector<Expr>& to, double side) {
    const Expr across[] = {a[1] * to[2] - a[2] * to[1], a[2] * to[0] - a[0] * to[2],
                           a[0] * to[1] - a[1] * to[0]};
    std::vector<Expr> n;
    for (const Expr component : across)
      n.push_back(input_of([&](int s) {
        return side * component.samples()[s] /
               std::hypot(across[0].samples()[s], across[1].samples()[s], across[2].samples()[s]);
      }));
    return n;
  };
  const auto solved = [&](const std::vector<Expr>& n, const std::vector<Expr>& to) {
    return solve_closed({n, {dot(a, n), dot(to, n), dot(n, n) - 1}, facts}).value();
  };
  const auto n = normal(b, 1);
  const ClosedForm first = solved(n, b);
  for (const double side : {1.0, -1.0}) {
    const auto m = normal(b, side);
    const auto again = as_earlier_or_opposite(solved(m, b), first, n);
    ASSERT_TRUE(again);
    Rates rates;
    for (const Expr x : n) move(rates, x);
    for (std::size_t i = 0; i < 3; ++i) {
      expect_equal(again->values[i], m[i]);
      for (const Level level : rate_levels)
        expect_equal(again->rates(rates, level)[i], side * rates.of(level, n[i]));
    }
  }
  EXPECT_FALSE(as_earlier_or_opposite(solved(normal(c, 1), c), first, n));
}

/// The other of two points on two circles is no opposite.
TEST_P(ClosedForms, AreNotWrittenByTheOtherSolution) {
  const auto x = inputs(2), y = inputs(2), p = inputs(2), q = inputs(2);
  const Expr about_p = dimension(dot(minus(x, p), minus(x, p))),
             about_q = dimension(dot(minus(x, q), minus(x, q)));
  const auto on_both = [&](const std::vector<Expr>& point) {
    const auto from_p = minus(point, p), from_q = minus(point, q);
    const Task task{point, {dot(from_p, from_p) - about_p, dot(from_q, from_q) - about_q}, facts};
    return solve_closed(task).value();
  };
  EXPECT_FALSE(as_earlier_or_opposite(on_both(y), on_both(x), x));
}

TEST_P(ClosedForms, NothingIsClaimedOfOtherEquations) {
  const Expr x = input(), y = input();
  EXPECT_FALSE(solve_closed({{x}, {x * x * x - y}, facts}));
  EXPECT_FALSE(solve_closed({{x}, {sin(x) - y}, facts}));
  EXPECT_FALSE(solve_closed({{x, y}, {x * y - 1, x * x + 2 * (y * y) - 3}, facts}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, ClosedForms, testing::Range(1u, 9u));

TEST(Tearing, FindsTheSmallestCoreThatIsWellConditioned) {
  Graph graph(1);
  const auto input = [&](double v) { return Expr::node(graph.input("x", {v})); };
  // x² + y² = 1 near (1, 0), x y³ + y = 0.: one of x and y must be torn; x from y is regular, y
  // from x is not.
  const Expr x = input(1), y = input(1e-3);
  const Expr one = Expr::node(graph.input("c", {1 + 1e-6}, false));
  const Facts facts;
  const TornOrder torn = Tearing({x * x + y * y - one, x * (y * y * y) + y}, {x, y}, facts).best();
  EXPECT_EQ(torn.unplaced, 0);
  EXPECT_EQ(torn.torn, std::vector<int>{1});
  ASSERT_EQ(torn.placed.size(), 1u);
  EXPECT_EQ(torn.placed[0].unknowns, std::vector<int>{0});
  EXPECT_EQ(torn.left_over, std::vector<int>{1});
}

}  // namespace
}  // namespace desmo::generate::closed_forms_test
