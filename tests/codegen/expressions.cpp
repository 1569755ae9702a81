// Expressions: what folds, what is shared, what they differentiate to, and how they are written.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <thread>

#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/kernel_source.h"
#include "formulations/codegen/record/differentiation.h"

namespace desmo::generate::expressions_test {
namespace {

struct Expressions : testing::Test {
  Graph graph{1};
  Expr x = Expr::node(graph.input("x", {2}));
  Expr y = Expr::node(graph.input("y", {3}));

  double value(Expr e) { return graph.samples(e.id())[0]; }
};

TEST_F(Expressions, FoldConstantsAndIdentities) {
  EXPECT_EQ((x + 0.0).id(), x.id());
  EXPECT_EQ((1.0 * x).id(), x.id());
  EXPECT_EQ((x - 0.0).id(), x.id());
  EXPECT_EQ((x / 1.0).id(), x.id());
  EXPECT_EQ((-(-x)).id(), x.id());
  EXPECT_TRUE((x * 0.0).is_zero());
  EXPECT_TRUE((x - x).is_zero());
  EXPECT_TRUE(graph.is((x * (1.0 / x)).id(), 1));
  EXPECT_TRUE((Expr(0) / x).is_zero());
  EXPECT_TRUE(graph.is((Expr(2) * 3.0 + sin(Expr(0))).id(), 6));
}

TEST_F(Expressions, RefuseConstantsThatAreNoNumbers) {
  EXPECT_THROW(Expr(0) / Expr(0), std::invalid_argument);
  EXPECT_THROW(sqrt(Expr(-1)), std::invalid_argument);
}

TEST_F(Expressions, AreInTheGraphOfTheirThread) {
  const int size = graph.size();
  std::thread([] {
    Graph other(1);
    EXPECT_TRUE(other.is((Expr(2) * 3.0).id(), 6));
  }).join();
  EXPECT_EQ(graph.size(), size);
  EXPECT_THROW(Graph(1), std::logic_error);
}

TEST_F(Expressions, TellWhatTheyAreMultiplesOf) {
  EXPECT_EQ((2 * x).factor(), 2);
  EXPECT_EQ((x * 2).factor(), 2);
  EXPECT_EQ((-(2 * (x + y))).factor(), 2);
  EXPECT_EQ((2 * x - 2 * y).factor(), 2);
  for (const Expr e : {x, -x, x * y, x + 2.0, 2 * x + y, Expr(2)}) EXPECT_EQ(e.factor(), 1);
  EXPECT_EQ((0.5 * -(2 * x)).id(), (-x).id());
}

TEST_F(Expressions, ShareCommonSubexpressions) {
  EXPECT_EQ((x + y).id(), (y + x).id());
  EXPECT_EQ((x * y).id(), (y * x).id());
  EXPECT_EQ((x * (-y)).id(), (-(x * y)).id());
  EXPECT_EQ((x + (-y)).id(), (x - y).id());
  EXPECT_NE((x - y).id(), (y - x).id());
  EXPECT_EQ((x * (x - y)).id(), (-(x * (y - x))).id());
}

TEST_F(Expressions, KeepTheirValueThroughEveryRule) {
  std::mt19937 generator(3);
  std::vector<std::pair<Expr, double>> pool{
      {x, 2}, {y, 3}, {Expr(0), 0}, {Expr(1), 1}, {Expr(-1), -1}};
  for (int i = 0; i < 400; ++i) {
    const auto& [a, va] = pool[generator() % pool.size()];
    const auto& [b, vb] = pool[generator() % pool.size()];
    std::pair<Expr, double> made = [&]() -> std::pair<Expr, double> {
      switch (generator() % 5) {
        case 0:
          return {a + b, va + vb};
        case 1:
          return {a - b, va - vb};
        case 2:
          return {a * b, va * vb};
        case 3:
          return {-a, -va};
        default:
          return vb != 0 ? std::pair{a / b, va / vb} : std::pair{sin(a), std::sin(va)};
      }
    }();
    if (std::abs(made.second) > 1e3) continue;
    EXPECT_NEAR(value(made.first), made.second, 1e-9 * (1 + std::abs(made.second)));
    pool.push_back(made);
  }
}

/// Quotients and products, twice differentiated.
TEST_F(Expressions, DifferentiateAsTheirDifferenceQuotients) {
  constexpr double h = 1e-4;
  const auto u_at = [](double t) { return 1.5 + std::sin(t); };
  const auto v_at = [](double t) { return 2 + 0.5 * t * t; };
  const auto f_at = [&](double t) {
    const double u = u_at(t), v = v_at(t);
    return u * u / v - std::sin(u * v) + v * std::cos(u) - u;
  };
  for (int k = 1; k <= 8; ++k) {
    const double t0 = 0.3 * k;
    const Expr u = Expr::node(graph.input("u", {u_at(t0)})),
               v = Expr::node(graph.input("v", {v_at(t0)}));
    const Expr f = u * u / v - sin(u * v) + v * cos(u) - u;
    Rates rates;
    rates.set(Level::velocity, u, std::cos(t0));
    rates.set(Level::velocity, v, t0);
    rates.set(Level::acceleration, u, -std::sin(t0));
    rates.set(Level::acceleration, v, 1);
    EXPECT_NEAR(value(rates.of(Level::velocity, f)), (f_at(t0 + h) - f_at(t0 - h)) / (2 * h), 1e-6)
        << t0;
    EXPECT_NEAR(value(rates.of(Level::acceleration, f)),
                (f_at(t0 + h) - 2 * f_at(t0) + f_at(t0 - h)) / (h * h), 1e-5)
        << t0;
  }
}

std::string written(Expr e) {
  std::ostringstream out;
  Emitter emitter(out, "", {e});
  emitter.prepare({e});
  return out.str() + emitter.text(e);
}

TEST_F(Expressions, AreWrittenWithTheParenthesesTheyNeed) {
  EXPECT_EQ(written(x - (y - 1.0)), "x - y + 1.0");
  EXPECT_EQ(written(x / (y * 2.0)), "x / (y * 2.0)");
  const Expr sum = x + y;
  EXPECT_EQ(written(sum * (x - y)), "(x + y) * (x - y)");
  EXPECT_EQ(written(sin(x + y) - x), "std::sin(x + y) - x");
  EXPECT_EQ(written(-(x * y)), "-(x * y)");
  EXPECT_EQ(written(-(x - y)), "y - x");
  const Expr xx = x * x, yy = y * y, squares = xx + yy;
  EXPECT_EQ(written(squares - 1.0), "x * x - 1.0 + y * y");  // two fused instructions
  EXPECT_EQ(written(squares - sum), "-x - y + x * x + y * y");
  EXPECT_EQ(written(-(x - y) / sum), "-((x - y) / (x + y))");
  EXPECT_EQ(written(x + -2.5), "x + (-2.5)");
}

/// Then only one operation waits for it.
TEST_F(Expressions, TakeLastWhatIsKnownLate) {
  EXPECT_EQ(written(sqrt(x) * y + (x - y * 2.0)), "x - y * 2.0 + y * std::sqrt(x)");
  EXPECT_EQ(written(sqrt(x) * (y * (x + 1.0))), "y * (x + 1.0) * std::sqrt(x)");
  EXPECT_EQ(written(1.0 / y - sqrt(x) - x * y), "1.0 / y - x * y - std::sqrt(x)");
  std::ostringstream out;
  Emitter emitter(out, "", {x + y * 2.0});
  emitter.assign("x", "late()", 30);
  EXPECT_EQ(emitter.text(x + y * 2.0), "y * 2.0 + x");
}

/// An expression with a name is computed once, wherever its terms stand.
TEST_F(Expressions, AreNotTakenApartWhereTheyAreShared) {
  const Expr sum = x + y;
  std::ostringstream out;
  Emitter emitter(out, "", {sum * x, sum - 1.0});
  emitter.prepare({sum * x, sum - 1.0});
  const std::string name = emitter.text(sum);
  EXPECT_NE(out.str().find(name + " = x + y"), std::string::npos);
  EXPECT_EQ(emitter.text(sum - 1.0), name + " - 1.0");
}

TEST(Literals, ReadBackToTheSameValue) {
  for (const double v : {0.1, 1.0, -3.0, 1e-300, 6.02e23, -1.0 / 3})
    EXPECT_EQ(
        std::strtod(literal(v)[0] == '(' ? literal(v).c_str() + 1 : literal(v).c_str(), nullptr),
        v);
  EXPECT_EQ(literal(2), "2.0");
  EXPECT_THROW(literal(INFINITY), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::generate::expressions_test
