// The start of a motion: the branch of the drawing, however rough it is and however far the drivers
// go from there.

#include "formulations/verification/branch/start.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>
#include <numbers>
#include <random>
#include <utility>

#include "cases/generators/dyad_chain.h"
#include "formulations/parts/groupwise/double_solution.h"
#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/reference/whole_system.h"
#include "tests/accuracy/scenes.h"
#include "tests/checked/rows.h"
#include "tests/dead_point.h"
#include "tests/properties/continuation.h"

namespace desmo::start_test {
namespace {

using Stage = FoundStart::Stage;
constexpr double turn = 2 * std::numbers::pi;

double size_of(const Model& m) {
  double size = 0;
  for (const double q : m.estimate) size = std::max(size, std::abs(q));
  return size;
}

/// Returns the largest distance of two positions, without whole turns of angles that are not
/// driven.
double distance(const Model& m, const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (const Entity& e : m.entities) {
    if (e.fixed) continue;
    for (int i = e.first; i < e.first + e.size; ++i) {
      double off = a[i] - b[i];
      if (e.kind == EntityKind::angle) off = std::remainder(off, turn);
      largest = std::max(largest, std::abs(off));
    }
  }
  return largest;
}

/// Returns the values of the drivers as they are drawn.
std::vector<double> drawn_drivers(const Model& m) {
  std::vector<double> values;
  for (const Driver& d : m.drivers) values.push_back(m.estimate[m.entities[d.coordinate].first]);
  return values;
}

/// Follows drivers from the drawing straight to these values, in steps of `step` in each driver, by
/// Newton's method alone. Empty: it did not converge.
std::vector<double> in_short_steps(Model m, const std::vector<double>& to, double step) {
  const std::vector<double> from = drawn_drivers(m);
  double longest = 0;
  for (std::size_t k = 0; k < to.size(); ++k)
    longest = std::max(longest, std::abs(to[k] - from[k]));
  const double seconds = std::max(0.01, longest / step * 0.01);  // in steps of 10 ms
  for (std::size_t k = 0; k < to.size(); ++k)
    m.drivers[k].motion = Polynomial{{from[k], (to[k] - from[k]) / seconds}};
  try {
    return double_solution(m, std::vector{0.0, seconds}).back().q;
  } catch (const std::runtime_error&) {
    return {};
  }
}

/// Sets constant drivers.
Model held_at(Model m, const std::vector<double>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) m.drivers[k].motion = Polynomial{{values[k]}};
  return m;
}

/// Returns whether the judge finds a regular way from the drawing to these values of the drivers.
/// Nearer to a singular position than this condition number says nothing has to be proven.
bool has_way(Model m, const std::vector<double>& to) {
  constexpr double max_condition = 1e7;
  const std::vector<double> from = drawn_drivers(m);
  for (std::size_t k = 0; k < to.size(); ++k)
    m.drivers[k].motion = Polynomial{{from[k], to[k] - from[k]}};
  Continuation way(m);
  way.begin(motions_of(m), 0);
  return way.go_to(1) && way.crossings() == 0 && way.max_condition() < max_condition;
}

/// All mechanisms from two turns before to two turns after the drawing, each time at another
/// instant. The arms of the delta are in line with its platform on the way of a turn.
TEST(Start, IsOnTheBranchOfTheDrawing) {
  int reached = 0, blocked = 0;
  for (const auto& [m, grid] : every_motion()) {
    // Sanitized code is as slow where a way is long.
    const double share = DESMO_SANITIZED ? 0.02 : 0.37,
                 later = grid.start + share * (grid.time(grid.instants - 1) - grid.start);
    std::vector<std::pair<double, double>> starts{{DESMO_SANITIZED ? 0.02 : 0.3, later}};
    if (!DESMO_SANITIZED)
      starts.insert(starts.end(), {{0, later},
                                   {0, grid.start},
                                   {-0.45, grid.start},
                                   {0.8, later},
                                   {-1.6, grid.start},
                                   {2, later}});
    for (const auto& [turns, time] : starts) {
      // Others take the delta through as many singular positions again.
      if (m.name == "delta" && (turns < 0 || turns > 1)) continue;
      std::vector<double> to;
      for (const Driver& d : m.drivers) {
        to.push_back(sample(d.motion, time).position);
        if (m.entities[d.coordinate].kind == EntityKind::angle) to.back() += turns * turn;
      }
      SCOPED_TRACE(m.name + ", " + std::to_string(turns) + " turns, " + std::to_string(time));
      const Model held = held_at(m, to);
      const FoundStart found = find_start(held, 0);
      if (found.stage != Stage::reached) {
        ++blocked;
        EXPECT_EQ(found.stage, Stage::drivers);
        EXPECT_FALSE(has_way(m, to)) << found.share;
        continue;
      }
      ++reached;
      EXPECT_EQ(found.share, 1);
      const std::vector<double> right = in_short_steps(m, to, 0.03);
      ASSERT_FALSE(right.empty());
      EXPECT_LT(distance(m, found.q, right), 1e-9 * size_of(m));
      for (const Entity& e : m.entities)
        if (!e.fixed && e.kind == EntityKind::angle && !independent_coordinates(m)[e.first])
          EXPECT_LE(std::abs(found.q[e.first] - m.estimate[e.first]), turn / 2 + 1e-9);
    }
  }
  std::cout << reached << " reached, " << blocked << " blocked\n";
  EXPECT_GE(reached, 10 * blocked);
}

Model four_bar(double coupler, double rocker, double base, double drawn) {
  DyadChain chain{.crank = 1, .start = drawn, .dyads = {}};
  chain.dyads.push_back(closed_dyad(crank_pin(chain), {base, 0, 0}, coupler, rocker, 1));
  MechanismBuilder builder("four_bar", 2);
  add(builder, chain);
  return make_model({"four_bar", builder.release(), {Polynomial{{drawn}}}, {}, {}, {}});
}

/// Bars of 1, 3 and 4 on a base of 5.99 are nearly stretched at half a turn: from there Newton's
/// method leads to the other branch.
TEST(Start, GoesShortStepsFromANearlyStretchedDrawing) {
  const Model m = four_bar(3, 4, 5.99, turn / 2);
  for (const double turns : {0, 1, -2})
    EXPECT_NEAR(m.value("dyad1/C.y", find_start(held_at(m, {2.5 + turns * turn}), 0).q), 1.127,
                1e-3);
}

/// A parallelogram is at a change point each half turn.
TEST(Start, PassesChangePoints) {
  const Model m = four_bar(4, 1, 4, turn / 4);
  for (const double to : {0.3, 0.6, -0.1, 1.7, -1.2}) {
    const FoundStart found = find_start(held_at(m, {to * turn}), 0);
    EXPECT_EQ(found.stage, Stage::reached) << to;
    EXPECT_NEAR(std::remainder(m.value("dyad1/psi", found.q) - to * turn, turn), 0, 1e-12) << to;
    std::vector<double> points;  // each half turn on the way
    for (double at = to > 0 ? 0.5 : 0; std::abs(at - 0.25) < std::abs(to - 0.25);
         at += to > 0 ? 0.5 : -0.5)
      points.push_back((at - 0.25) / (to - 0.25));
    ASSERT_EQ(found.passed.size(), points.size()) << to;
    for (std::size_t i = 0; i < points.size(); ++i) EXPECT_NEAR(found.passed[i], points[i], 1e-6);
  }
}

/// One that begins on a change point has no proven start.
TEST(Start, SaysThatItIsOnAChangePoint) {
  const FoundStart found = find_start(held_at(four_bar(4, 1, 4, turn / 4), {turn / 2}), 0);
  EXPECT_EQ(found.stage, Stage::drivers);
  EXPECT_NEAR(found.share, 1, 1e-6);
  EXPECT_NEAR(found.q[0], -1, 1e-3);
  ASSERT_NE(found.group, no_position);
}

TEST(Start, SaysWhereTheDriversAreBlocked) {
  const double drawn = std::numbers::pi / 3, to = dead_point + 0.2;
  const Model m = locking_four_bar();
  const FoundStart found = find_start(held_at(m, {to}), 0);
  EXPECT_EQ(found.stage, Stage::drivers);
  EXPECT_NEAR(drawn + found.share * (to - drawn), dead_point, 1e-9);
  EXPECT_NEAR(m.value("crank/theta", found.q), dead_point, 1e-9);
  ASSERT_NE(found.group, no_position);
  EXPECT_EQ(m.groups[found.group].name, "dyad1/SG-I");
}

TEST(Start, SaysThatADrawingIsSingular) {
  const Model m = locking_four_bar(Polynomial{{dead_point}});
  const FoundStart found = find_start(held_at(m, {1.0}), 0);
  EXPECT_EQ(found.stage, Stage::drawing);
  EXPECT_EQ(found.share, 0);
  EXPECT_EQ(found.q, m.estimate);
  ASSERT_NE(found.group, no_position);
  EXPECT_EQ(m.groups[found.group].name, "dyad1/SG-I");
}

/// A coupler too short to close the loop: the way ends where crank pin, coupler and rocker are in
/// line. There (1 − λ) Φ(drawing) is what the closure lacks.
TEST(Start, SaysHowFarADrawingThatCannotCloseLeads) {
  Model m = locking_four_bar();
  for (Constraint& c : m.constraints)
    if (c.name.starts_with("dyad1/coupler")) c.constants[0] = 1;
  const FoundStart found = find_start(m, 0);
  EXPECT_EQ(found.stage, Stage::drawing);
  // With the length l of coupler and rocker in line: l² = 1 + (1 − λ) (9 − 1).
  const double line = std::hypot(8 - 2 * std::cos(std::numbers::pi / 3), std::sqrt(3.0)) - 6;
  EXPECT_NEAR(found.share, 1 - (line * line - 1) / 8, 1e-6);
}

/// After 16,667 turns of the crank. Nobody follows them all.
TEST(Start, LeavesOutManyTurns) {
  Model m = make_model(library_scene("slider_crank"));
  m.drivers[0].motion = Polynomial{{0, 10.473}};
  const double time = 1e4;
  const FoundStart found = find_start(m, time);
  EXPECT_EQ(found.stage, Stage::reached);
  EXPECT_EQ(m.value("theta", found.q), 10.473 * time);
  const std::vector<double> right = in_short_steps(m, {std::remainder(10.473 * time, turn)}, 0.01);
  EXPECT_LT(std::abs(m.value("s", found.q) - m.value("s", right)), 1e-10 * size_of(m));
}

/// A worm turns the crank of a four-bar by 2π/ratio a turn of the fast crank, whose slider takes
/// all tests. What has moved is not back, however little: after 1,500 turns the four-bar is
/// elsewhere.
TEST(Start, LeavesOutNoTurnOfAShaftThatASlowOneFollows) {
  const auto start = [](const std::string& ratio) {
    const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "worm", "dimension": 2,
      "points": {"O": [0, 0], "P": [30, 0], "C": [-1, 0], "Q": [100, 0], "R": [115, 25.980762113533157],
        "B": [187.96675386669742, 58.78095769460853], "G": [200, 0]},
      "vectors": {"x": [1, 0]},
      "ground": {"points": ["O", "Q", "G"], "vectors": ["x"]},
      "bodies": {"fast": {"points": ["O", "P"]}, "rod": {"points": ["P", "C"]},
        "slider": {"points": ["C"], "vectors": ["x"]}, "slow": {"points": ["Q", "R"]},
        "coupler": {"points": ["R", "B"]}, "rocker": {"points": ["B", "G"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "fast"], "points": ["O"]},
        {"type": "revolute", "bodies": ["fast", "rod"], "points": ["P"]},
        {"type": "revolute", "bodies": ["rod", "slider"], "points": ["C"]},
        {"type": "prismatic", "bodies": ["ground", "slider"], "vectors": ["x"], "points": ["O", "C"]},
        {"type": "revolute", "bodies": ["ground", "slow"], "points": ["Q"]},
        {"type": "revolute", "bodies": ["slow", "coupler"], "points": ["R"]},
        {"type": "revolute", "bodies": ["coupler", "rocker"], "points": ["B"]},
        {"type": "revolute", "bodies": ["rocker", "ground"], "points": ["G"]}],
      "coordinates": {"a": {"angle": ["O", "P"]}, "b": {"angle": ["Q", "R"]}},
      "couplings": {"worm": {"sum": {"a": 1, "b": -)" +
                                        ratio + R"(}}}, "drivers": ["a"]},
      "motion": {"a": {"type": "constant", "value": 0}}, "time": {"at": 0}})",
                                    "worm.json", "");
    return find_start(held_at(make_model(scene), {1500 * turn}), 0).stage;
  };
  EXPECT_EQ(start("1"), Stage::reached);
  EXPECT_EQ(start("2000"), Stage::drivers);
  if (DESMO_SANITIZED) return;
  // Ten times max_drift a turn, and a tenth of it, which would have to last for 10⁹ turns.
  EXPECT_EQ(start("6.3e8"), Stage::drivers);
  EXPECT_EQ(start("6.3e10"), Stage::reached);
}

/// A differential: wheel c makes half of the turns that a and b make. Turns of both lead back where
/// they are as many, those of one alone do not.
TEST(Start, LeavesOutTurnsOfSeveralDriversWhereEachLeadsBack) {
  const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 2, "mechanism": {
      "format": "desmo-mechanism", "version": 1, "name": "differential", "dimension": 2,
      "points": {"O": [0, 0], "A": [1, 0], "P": [3, 0], "B": [4, 0], "Q": [6, 0], "C": [7, 0]},
      "ground": {"points": ["O", "P", "Q"]},
      "bodies": {"first": {"points": ["O", "A"]}, "second": {"points": ["P", "B"]},
        "third": {"points": ["Q", "C"]}},
      "joints": [{"type": "revolute", "bodies": ["ground", "first"], "points": ["O"]},
        {"type": "revolute", "bodies": ["ground", "second"], "points": ["P"]},
        {"type": "revolute", "bodies": ["ground", "third"], "points": ["Q"]}],
      "coordinates": {"a": {"angle": ["O", "A"]}, "b": {"angle": ["P", "B"]},
        "c": {"angle": ["Q", "C"]}},
      "couplings": {"differential": {"sum": {"a": 1, "b": 1, "c": -2}}}, "drivers": ["a", "b"]},
      "motion": {"a": {"type": "constant", "value": 0}, "b": {"type": "constant", "value": 0}},
      "time": {"at": 0}})",
                                  "differential.json", "");
  const Model m = make_model(scene);
  const FoundStart equal = find_start(held_at(m, {1e4 * turn + 0.1, 1e4 * turn + 0.3}), 0);
  EXPECT_EQ(equal.stage, Stage::reached);
  EXPECT_NEAR(m.value("c", equal.q), 1e4 * turn + 0.2, 1e-9);
  const FoundStart other = find_start(held_at(m, {1e4 * turn, 10001 * turn}), 0);
  EXPECT_EQ(other.stage, Stage::reached);
  EXPECT_NEAR(m.value("c", other.q), 10000.5 * turn, 1e-9);
  EXPECT_NEAR(m.value("C.x", other.q), 5, 1e-9);
}

/// The linkage locks a third of a turn from where it is drawn. Beyond a whole turn the crank could
/// stand as it does before, but nothing leads there.
TEST(Start, LeavesOutNoTurnThatIsBlocked) {
  const Model m = make_model(scene_file("peaucellier"));
  const double drawn = drawn_drivers(m)[0];
  for (const double to : {drawn - turn - 0.1, drawn + turn + 0.1, drawn + 300 * turn + 0.1}) {
    const FoundStart found = find_start(held_at(m, {to}), 0);
    EXPECT_EQ(found.stage, Stage::drivers) << to;
    EXPECT_LT(found.share, 0.6) << to;
  }
}

TEST(Start, HasNoWayToWhatIsNotFinite) {
  const Model m = locking_four_bar();
  for (const double bad : {NAN, INFINITY}) {
    for (const FoundStart& found : {find_start(held_at(m, {bad}), 0), find_start(m, bad)}) {
      EXPECT_EQ(found.stage, Stage::drivers);
      EXPECT_EQ(found.share, 0);
      for (const double q : found.q) EXPECT_TRUE(std::isfinite(q));
    }
  }
}

/// Returns a bucket on its four-bar, driven by a cylinder, on an arm: an excavator's.
Model excavator() { return make_model(scene_file("excavator_rough_drawing")); }

/// Moves all drawn points by normally distributed offsets.
void roughen(Model& m, std::normal_distribution<double> off, std::mt19937& generator) {
  for (const Entity& e : m.entities)
    if (!e.fixed && e.kind == EntityKind::point)
      for (int i = e.first; i < e.first + e.size; ++i) m.estimate[i] += off(generator);
}

TEST(Start, TakesARoughDrawingForWhatItIsNearest) {
  const Model m = excavator();
  const FoundStart drawn = find_start(m, 0);
  EXPECT_EQ(drawn.stage, Stage::reached);
  EXPECT_NEAR(m.value("L.x", drawn.q), 5.20201505293, 1e-10);
  EXPECT_NEAR(m.value("L.y", drawn.q), 3.93970578587, 1e-10);
  EXPECT_NEAR(m.value("phi_bucket", drawn.q), 2.57954545505, 1e-10);
  std::mt19937 generator(1);
  for (const double part : {0.01, 0.03, 0.1})  // of the shortest link
    for (int i = 0; i < (DESMO_SANITIZED ? 1 : 40); ++i) {
      Model rough = m;
      roughen(rough, std::normal_distribution<double>(0, part * 0.449), generator);
      const FoundStart found = find_start(rough, 0);
      EXPECT_EQ(found.stage, Stage::reached) << part;
      EXPECT_LT(distance(m, found.q, drawn.q), 1e-12) << part;
    }
}

/// Random starts of the three cylinders: the answer is that of short steps, or a blocked way.
TEST(Start, FollowsARoughDrawingToAnyStart) {
  const Model m = excavator();
  const Model drawn = [&] {  // as it closes
    Model closed = m;
    const FoundStart found = find_start(held_at(m, drawn_drivers(m)), 0);
    EXPECT_EQ(found.stage, Stage::reached);
    closed.estimate = found.q;
    return closed;
  }();
  std::mt19937 generator(5);
  std::uniform_real_distribution<double> boom(1.0, 2.2), arm(0.9, 2.2), bucket(1.0, 1.9);
  int reached = 0, blocked = 0;
  for (int i = 0; i < (DESMO_SANITIZED ? 4 : 80); ++i) {
    const std::vector<double> to{boom(generator), arm(generator), bucket(generator)};
    const FoundStart found = find_start(held_at(m, to), 0);
    (found.stage == Stage::reached ? reached : blocked)++;
    if (found.stage == Stage::reached) {
      const std::vector<double> right = in_short_steps(drawn, to, 0.005);
      ASSERT_FALSE(right.empty());
      EXPECT_LT(distance(m, found.q, right), 1e-9) << to[0] << ' ' << to[1] << ' ' << to[2];
    } else {
      EXPECT_EQ(found.stage, Stage::drivers);
      EXPECT_FALSE(has_way(drawn, to)) << to[0] << ' ' << to[1] << ' ' << to[2];
    }
  }
  std::cout << reached << " reached, " << blocked << " blocked\n";
  EXPECT_GT(reached, DESMO_SANITIZED ? 0 : 30);
}

/// Along the homotopy Φ, Φ̇ and Φ̈ are (1 − λ) Φ₀, −Φ₀ and 0.
TEST(Start, KeepsTheHomotopysEquations) {
  Model m = held_at(excavator(), drawn_drivers(excavator()));
  const WholeSystem system(m);
  std::mt19937 generator(3);
  roughen(m, std::normal_distribution<double>(0, 0.02), generator);
  std::vector<double> drawn = m.estimate, residual(system.rows());
  drawn.insert(drawn.end(), m.fixed_values.begin(), m.fixed_values.end());
  system.residual<double>(drawn, residual);
  std::vector<std::vector<double>> initial;
  int next = 0;
  for (const Constraint& c : m.constraints) {
    initial.emplace_back();
    for (int r = 0; r < rows(c); ++r)
      initial.back().push_back(c.left_out >> r & 1 ? NAN : residual[next++]);
  }
  BranchPath path(m, BranchPath::max_tests, initial);
  ASSERT_TRUE(path.start_at({0, {m.estimate, {}, {}}}));
  for (const double time : {0.0, 0.3, 1.0}) {
    if (time > 0) ASSERT_EQ(path.go_to(time).end, PathEnd::same);
    const auto& [q, qd, qdd] = path.present().values;
    std::vector<Jet<double>> state, phi(system.rows());
    for (int i = 0; i < m.coordinates(); ++i) state.emplace_back(q[i], qd[i], qdd[i]);
    for (const double x : m.fixed_values) state.emplace_back(x);
    system.residual<Jet<double>>(state, phi);
    int row = 0;
    for (std::size_t c = 0; c < m.constraints.size(); ++c)
      for (int r = 0; r < rows(m.constraints[c]); ++r) {
        if (m.constraints[c].left_out >> r & 1) continue;
        EXPECT_NEAR(phi[row].value, (1 - time) * initial[c][r], 1e-12);
        EXPECT_NEAR(phi[row].first, -initial[c][r], 1e-12);
        EXPECT_NEAR(phi[row].second, 0, 1e-11);
        ++row;
      }
  }
}

}  // namespace
}  // namespace desmo::start_test
