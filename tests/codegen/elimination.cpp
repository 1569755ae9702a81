// Elimination of the generator: its orders, and how far each is trusted.

#include "formulations/codegen/eliminate/elimination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace desmo::generate::elimination_test {
namespace {

/// Returns an input that has value(s) at sample s.
Expr input(Graph& graph, std::size_t samples, const auto& value) {
  std::vector<double> values;
  for (std::size_t s = 0; s < samples; ++s) values.push_back(value(s));
  return Expr::node(graph.input("a", values));
}

/// Returns the right-hand side that has this solution.
std::vector<Expr> right_side(const SparseRows& rows, const std::vector<Expr>& solution) {
  std::vector<Expr> b;
  for (const auto& row : rows) {
    b.emplace_back(0);
    for (const auto& [j, a] : row) b.back() = b.back() + a * solution[j];
  }
  return b;
}

/// A link that turns, and its pivots with it.
struct TurningLink {
  Expr cosine, sine;
  SparseRows rows{{{0, cosine}, {1, sine}}, {{0, -sine}, {1, cosine}}};
};

TEST(Elimination, SolvesRandomSparseSystemsAtEverySample) {
  constexpr int n = 8, samples = 4;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Graph graph(samples);
    const auto at_random = [&](double offset) {
      return input(graph, samples, [&](std::size_t) { return uniform(generator) + offset; });
    };
    SparseRows rows(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (i != j && generator() % 3) continue;
        if (i != j && generator() % 4 == 0) {
          rows[i].emplace(j, Expr(1));
          continue;
        }
        rows[i].emplace(j, at_random(i == j ? 3 : 0));
      }
    std::vector<Expr> x;
    for (int j = 0; j < n; ++j) x.push_back(at_random(0));
    const std::vector<Expr> solution = Elimination(rows).solve(right_side(rows, x));
    for (int j = 0; j < n; ++j)
      for (int s = 0; s < samples; ++s)
        EXPECT_NEAR(graph.samples(solution[j].id())[s], graph.samples(x[j].id())[s], 1e-10);
  }
}

TEST(Elimination, TakesConstantPivotsFirstAndMonitorsTheOthers) {
  Graph graph(1);
  const Expr a = Expr::node(graph.input("a", {0.5})), b = Expr::node(graph.input("b", {0.7}));
  // x + a y = …, b x + y = …: the pivots are 1, then 1 − a b.
  const Elimination e({{{0, Expr(1)}, {1, a}}, {{0, b}, {1, Expr(1)}}});
  ASSERT_EQ(e.monitors().size(), 1u);
  EXPECT_NEAR(graph.samples(e.monitors()[0].pivot.id())[0], 1 - 0.5 * 0.7, 1e-15);
}

/// Returns whether all monitors trust the elimination at a sample.
bool is_trusted(const Elimination& e, std::size_t sample) {
  const auto size = [&](Expr value) { return std::abs(value.samples()[sample]); };
  for (const PivotMonitor& m : e.monitors()) {
    for (const auto& [value, bound] : m.magnified)
      if (!(size(value) < bound)) return false;
    for (const auto& [value, bound] : m.against)
      if (!(size(m.pivot) > bound * size(value))) return false;
  }
  return true;
}

/// Rows that point along another axis at each sample have no pivot that serves two of them. At the
/// last sample two rows are equal.
TEST(Elimination, SolvesRowsThatPointAnyWayByTheirAdjugate) {
  for (const int n : {2, 3})
    for (const bool follow_another : {false, true}) {
      const int samples = n + 1;
      Graph graph(samples);
      SparseRows rows;
      for (int i = 0; i < n; ++i) {
        rows.emplace_back();
        for (int j = 0; j < n; ++j)
          rows.back().emplace(j, input(graph, samples, [&](int s) {
                                return s < n ? (i + s) % n == j : j == 0 ? 2.0 : 0.5;
                              }));
      }
      if (follow_another) {  // x_n + x_0 = …, x_n in all other rows, too
        for (auto& row : rows) row.emplace(n, Expr(0.25));
        rows.push_back({{n, Expr(1)}, {0, Expr(1)}});
      }
      const auto size = static_cast<int>(rows.size());
      std::vector<Expr> x;
      for (int j = 0; j < size; ++j)
        x.push_back(input(graph, samples, [&](int s) { return 1 + j - 0.3 * s; }));
      const Elimination e(rows);
      const std::vector<Expr> solution = e.solve(right_side(rows, x));
      for (int s = 0; s < n; ++s) {
        EXPECT_TRUE(is_trusted(e, s)) << n << ", " << s;
        for (int j = 0; j < size; ++j)
          EXPECT_NEAR(solution[j].samples()[s], x[j].samples()[s], 1e-14) << n << ", " << s;
      }
      EXPECT_FALSE(is_trusted(e, n)) << n;
    }
}

/// The pivot that serves the first samples vanishes at others, which a second order serves. At the
/// last sample the matrix is singular, and no order does.
TEST(Elimination, HasAFurtherOrderForSamplesThatTheFirstDoesNotServe) {
  const std::vector<double> angles{0.3, 0.5, -0.4, 0.2, std::numbers::pi / 2, 1.55};
  const std::size_t samples = angles.size() + 1;
  Graph graph(static_cast<int>(samples));
  const auto of_angle = [&](auto value) {
    return input(graph, samples,
                 [&](std::size_t s) { return s < angles.size() ? value(angles[s]) : 0; });
  };
  const SparseRows rows = TurningLink{
      of_angle([](double a) { return std::cos(a); }), of_angle([](double a) {
        return std::sin(a);
      })}.rows;
  const std::vector<Expr> x{of_angle([](double a) { return 1 + a; }),
                            of_angle([](double a) { return 2 - a; })};

  EXPECT_EQ(eliminations(rows, 1, 4).size(), 1u);
  const std::vector<Elimination> orders = eliminations(rows, 3, 4);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_FALSE(is_trusted(orders[0], 4));
  for (std::size_t s = 0; s < angles.size(); ++s) {
    const auto trusted =
        std::ranges::find_if(orders, [&](const Elimination& e) { return is_trusted(e, s); });
    ASSERT_NE(trusted, orders.end()) << s;
    const std::vector<Expr> solution = trusted->solve(right_side(rows, x));
    for (const int j : {0, 1}) EXPECT_NEAR(solution[j].samples()[s], x[j].samples()[s], 1e-13) << s;
  }
  for (const Elimination& e : orders) EXPECT_FALSE(is_trusted(e, angles.size()));
}

/// A pivot may be a tenth of its column. Ten times more would ask for orders that nothing needs,
/// ten times less for none where one vanishes soon.
TEST(Elimination, HasNoFurtherOrderWherePivotsAreLargeEnough) {
  for (const auto& [angle, orders] : {std::pair{0.9, 1u}, std::pair{1.52, 2u}}) {
    Graph graph(2);
    const TurningLink link{Expr::node(graph.input("a", {std::cos(0.2), std::cos(angle)})),
                           Expr::node(graph.input("a", {std::sin(0.2), std::sin(angle)}))};
    EXPECT_EQ(eliminations(link.rows, 3, 1).size(), orders) << angle;
  }
}

/// Rounding errors grow with the multipliers, whose limit is some 1000 times the largest sample.
/// Ten times less would refuse what is exact to 12 digits; ten times more would not refuse what is
/// not.
TEST(Elimination, IsTrustedAsFarAsItIsExact) {
  struct At {
    double pivot;
    bool is_trusted;
  };
  for (const auto& [pivot, trusted] : {At{1, true}, At{1.0 / 150, true}, At{1.0 / 9000, false}}) {
    double error = 0;
    for (int k = 1; k <= 20; ++k) {
      Graph graph(2);  // the first sample chooses
      const auto both = [&](double at_first, double later) {
        return Expr::node(graph.input("a", {at_first, later}));
      };
      const SparseRows rows{{{0, both(1, pivot)}, {1, both(0.1, std::sqrt(0.01 * k))}},
                            {{0, both(1, 0.7)}, {1, both(0.2, std::cos(0.1 * k))}}};
      const std::vector<Expr> x{both(1, std::sin(k)), both(1, std::cos(3 * k))};
      const Elimination e(rows, {0}, Unsound::has_largest_worst);
      const std::vector<Expr> solution = e.solve(right_side(rows, x));
      EXPECT_EQ(is_trusted(e, 1), trusted) << pivot << ", " << k;
      error = std::max(error, std::abs(solution[0].samples()[1] - x[0].samples()[1]));
    }
    EXPECT_EQ(error < 1e-13, trusted) << error;
  }
}

}  // namespace
}  // namespace desmo::generate::elimination_test
