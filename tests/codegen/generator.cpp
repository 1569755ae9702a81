// The generator: expressions, elimination and the source that comes of them.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <random>
#include <sstream>
#include <string>

#include "cases/generators/cases.h"
#include "formulations/codegen/eliminate/elimination.h"
#include "formulations/codegen/emit/emission.h"
#include "formulations/codegen/emit/kernel_source.h"
#include "formulations/structure/part_type.h"
#include "tests/mechanisms.h"

namespace desmo::generate::generator_test {
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

/// So that only one operation waits for it.
TEST_F(Expressions, TakeLastWhatIsKnownLate) {
  EXPECT_EQ(written(sqrt(x) * y + (x - y * 2.0)), "x - y * 2.0 + y * std::sqrt(x)");
  EXPECT_EQ(written(sqrt(x) * (y * (x + 1.0))), "y * (x + 1.0) * std::sqrt(x)");
  EXPECT_EQ(written(1.0 / y - sqrt(x) - x * y), "1.0 / y - x * y - std::sqrt(x)");
  std::ostringstream out;
  Emitter emitter(out, "", {x + y * 2.0});
  emitter.assign("x", "late()", 30);
  EXPECT_EQ(emitter.text(x + y * 2.0), "y * 2.0 + x");
}

/// What has a name is computed once, wherever its terms stand.
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
}

TEST(Elimination, SolvesRandomSparseSystemsAtEverySample) {
  constexpr int n = 8, samples = 4;
  for (unsigned seed = 1; seed <= 20; ++seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    Graph graph(samples);
    std::vector<std::map<int, Expr>> rows(n);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        if (i != j && generator() % 3) continue;
        if (i != j && generator() % 4 == 0) {
          rows[i].emplace(j, Expr(1));
          continue;
        }
        std::vector<double> values;
        for (int s = 0; s < samples; ++s) values.push_back(uniform(generator) + (i == j ? 3 : 0));
        rows[i].emplace(j, Expr::node(graph.input("a", values)));
      }
    std::vector<Expr> x, b(n);
    for (int j = 0; j < n; ++j) {
      std::vector<double> values;
      for (int s = 0; s < samples; ++s) values.push_back(uniform(generator));
      x.push_back(Expr::node(graph.input("x", values)));
    }
    for (int i = 0; i < n; ++i)
      for (const auto& [j, a] : rows[i]) b[i] = b[i] + a * x[j];
    const std::vector<Expr> solution = Elimination(rows).solve(b);
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

/// Whether all monitors trust the elimination at a sample.
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
      const auto input = [&](auto value) {
        std::vector<double> values;
        for (int s = 0; s < samples; ++s) values.push_back(value(s));
        return Expr::node(graph.input("a", values));
      };
      std::vector<std::map<int, Expr>> rows;
      for (int i = 0; i < n; ++i) {
        rows.emplace_back();
        for (int j = 0; j < n; ++j)
          rows.back().emplace(j, input([&](int s) {
                                return s < n ? (i + s) % n == j : j == 0 ? 2.0 : 0.5;
                              }));
      }
      if (follow_another) {  // x_n + x_0 = …, x_n in all other rows, too
        for (auto& row : rows) row.emplace(n, Expr(0.25));
        rows.push_back({{n, Expr(1)}, {0, Expr(1)}});
      }
      const auto size = static_cast<int>(rows.size());
      std::vector<Expr> x, b(size);
      for (int j = 0; j < size; ++j) x.push_back(input([&](int s) { return 1 + j - 0.3 * s; }));
      for (int i = 0; i < size; ++i)
        for (const auto& [j, a] : rows[i]) b[i] = b[i] + a * x[j];
      const Elimination e(rows);
      const std::vector<Expr> solution = e.solve(b);
      for (int s = 0; s < n; ++s) {
        EXPECT_TRUE(is_trusted(e, s)) << n << ", " << s;
        for (int j = 0; j < size; ++j)
          EXPECT_NEAR(solution[j].samples()[s], x[j].samples()[s], 1e-14) << n << ", " << s;
      }
      EXPECT_FALSE(is_trusted(e, n)) << n;
    }
}

/// A link that turns: the pivot that serves the first samples vanishes at others, which a second
/// order serves. At the last sample the matrix is singular, and no order does.
TEST(Elimination, HasAFurtherOrderForSamplesThatTheFirstDoesNotServe) {
  const std::vector<double> angles{0.3, 0.5, -0.4, 0.2, std::numbers::pi / 2, 1.55};
  const std::size_t samples = angles.size() + 1;
  Graph graph(static_cast<int>(samples));
  const auto input = [&](auto value) {
    std::vector<double> values;
    for (const double angle : angles) values.push_back(value(angle));
    values.push_back(0);
    return Expr::node(graph.input("a", values));
  };
  const Expr cosine = input([](double a) { return std::cos(a); }),
             sine = input([](double a) { return std::sin(a); });
  const Expr x = input([](double a) { return 1 + a; }), y = input([](double a) { return 2 - a; });
  const std::vector<std::map<int, Expr>> rows{{{0, cosine}, {1, sine}}, {{0, -sine}, {1, cosine}}};
  const std::vector<Expr> b{cosine * x + sine * y, cosine * y - sine * x};

  EXPECT_EQ(eliminations(rows, 1, 4).size(), 1u);
  const std::vector<Elimination> orders = eliminations(rows, 3, 4);
  ASSERT_EQ(orders.size(), 2u);
  EXPECT_FALSE(is_trusted(orders[0], 4));
  for (std::size_t s = 0; s < angles.size(); ++s) {
    const auto trusted =
        std::ranges::find_if(orders, [&](const Elimination& e) { return is_trusted(e, s); });
    ASSERT_NE(trusted, orders.end()) << s;
    const std::vector<Expr> solution = trusted->solve(b);
    EXPECT_NEAR(solution[0].samples()[s], x.samples()[s], 1e-13) << s;
    EXPECT_NEAR(solution[1].samples()[s], y.samples()[s], 1e-13) << s;
  }
  for (const Elimination& e : orders) EXPECT_FALSE(is_trusted(e, angles.size()));
}

/// A pivot may be a tenth of its column. Ten times more would ask for orders that nothing needs,
/// ten times less for none where one vanishes soon.
TEST(Elimination, HasNoFurtherOrderWherePivotsAreLargeEnough) {
  for (const auto& [angle, orders] : {std::pair{0.9, 1u}, std::pair{1.52, 2u}}) {
    Graph graph(2);
    const Expr cosine = Expr::node(graph.input("a", {std::cos(0.2), std::cos(angle)})),
               sine = Expr::node(graph.input("a", {std::sin(0.2), std::sin(angle)}));
    EXPECT_EQ(eliminations({{{0, cosine}, {1, sine}}, {{0, -sine}, {1, cosine}}}, 3, 1).size(),
              orders)
        << angle;
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
      const auto input = [&](double at_first, double later) {
        return Expr::node(graph.input("a", {at_first, later}));
      };
      const Expr a = input(1, pivot), p = input(0.1, std::sqrt(0.01 * k)), q = input(1, 0.7),
                 r = input(0.2, std::cos(0.1 * k));
      const Expr x = input(1, std::sin(k)), y = input(1, std::cos(3 * k));
      const Elimination e({{{0, a}, {1, p}}, {{0, q}, {1, r}}}, {0}, Unsound::has_largest_worst);
      const std::vector<Expr> solution = e.solve({a * x + p * y, q * x + r * y});
      EXPECT_EQ(is_trusted(e, 1), trusted) << pivot << ", " << k;
      error = std::max(error, std::abs(solution[0].samples()[1] - x.samples()[1]));
    }
    EXPECT_EQ(error < 1e-13, trusted) << error;
  }
}

TEST(Elimination, RefusesAStructurallySingularMatrix) {
  Graph graph(1);
  EXPECT_THROW(Elimination({{{0, Expr(1)}}, {{0, Expr(2)}}}), std::invalid_argument);
}

TEST(PartTypes, AreEqualForTwinsAndDifferOtherwise) {
  const Model m = truck_model(2);
  const auto fingerprint = [&](const char* name) {
    for (const PartDefinition& part : make_partition(m, Partition::group))
      if (m.groups[part.groups.front()].name == name) return describe_type(m, part).fingerprint;
    return std::string("none");
  };
  EXPECT_EQ(fingerprint("axle1/SG-II"), fingerprint("axle2/SG-III"));
  EXPECT_EQ(fingerprint("axle1/SG-IV"), fingerprint("axle2/SG-V"));
  EXPECT_NE(fingerprint("axle1/SG-II"), fingerprint("axle1/SG-IV"));
  EXPECT_EQ(fingerprint("axle1/SG-II").find("axle"), std::string::npos);  // never by name
}

std::string read(const std::string& path) {
  std::ifstream in(path);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(Generate, WritesTheSameBytesEveryTime) {
  using Files = std::map<std::string, std::string>;
  const auto generate = [](const std::string& name) {
    const std::filesystem::path folder = testing::TempDir() + name;
    std::filesystem::create_directory(folder);
    EXPECT_EQ(std::system((DESMO_GENERATE " " + folder.string()).c_str()), 0);
    Files files;
    for (const auto& file : std::filesystem::directory_iterator(folder))
      files[file.path().filename()] = read(file.path());
    return files;
  };
  Files a = generate("kernels_a");
  EXPECT_EQ(a, generate("kernels_b"));
  ASSERT_EQ(a.size(), 6u);
  EXPECT_NE(a["cases_kernels.cpp"].find("const double q_WL_x = q[in["), std::string::npos)
      << "names are readable";
  EXPECT_NE(a["cases_explicit_kernels.cpp"].find("// C.x, C.y: two circles\n"), std::string::npos);
  EXPECT_NE(a["library_lane_kernels.cpp"].find("library_lane_kernels("), std::string::npos);
}

TEST(Generate, FailsWhereItCannotWrite) {
  EXPECT_NE(std::system(DESMO_GENERATE " /nonexistent 2>/dev/null"), 0);
  EXPECT_NE(std::system(DESMO_GENERATE " 2>/dev/null"), 0);
}

}  // namespace
}  // namespace desmo::generate::generator_test
