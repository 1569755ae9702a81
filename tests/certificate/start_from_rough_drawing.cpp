// Starts from a rough drawing: a homotopy leads to the positions that it means.

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/start.h"
#include "formulations/verification/reference/whole_system.h"
#include "tests/certificate/starts.h"
#include "tests/checked/rows.h"

namespace desmo::start_from_rough_drawing_test {
namespace {

using Stage = FoundStart::Stage;

/// Returns a bucket on its four-bar, driven by a cylinder, on an arm: an excavator's.
Model excavator() { return make_model(scene_file("excavator_rough_drawing")); }

/// Moves all drawn points by normally distributed offsets.
void roughen(Model& m, std::normal_distribution<double> off, std::mt19937& generator) {
  for (const Entity& e : m.entities)
    if (!e.fixed && e.kind == EntityKind::point)
      for (int i = e.first; i < e.first + e.size; ++i) m.estimate[i] += off(generator);
}

TEST(StartFromRoughDrawing, TakesARoughDrawingForWhatItIsNearest) {
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
      EXPECT_LT(position_distance(m, found.q, drawn.q), 1e-12) << part;
    }
}

/// Along the homotopy Φ, Φ̇ and Φ̈ are (1 − λ) Φ₀, −Φ₀ and 0.
TEST(StartFromRoughDrawing, KeepsTheHomotopysEquations) {
  Model m = held_at(excavator(), drawn_drivers(excavator()));
  const WholeSystem system(m);
  std::mt19937 generator(3);
  roughen(m, std::normal_distribution<double>(0, 0.02), generator);
  std::vector<double> residual(system.rows());
  system.residual<double>(m.state_of(m.estimate), residual);
  int next = 0;
  for (Constraint& c : m.constraints)
    for (int r = 0; r < rows(c); ++r)
      c.initial_residual.push_back(c.left_out >> r & 1 ? NAN : residual[next++]);
  BranchPath path(m);
  ASSERT_TRUE(path.start_at({0, {m.estimate, {}, {}}}));
  for (const double time : {0.0, 0.3, 1.0}) {
    if (time > 0) ASSERT_EQ(path.go_to(time).end, PathEnd::same);
    const auto& [q, qd, qdd] = path.present().values;
    std::vector<Jet<double>> state, phi(system.rows());
    for (int i = 0; i < m.coordinates(); ++i) state.emplace_back(q[i], qd[i], qdd[i]);
    for (const double x : m.fixed_values) state.emplace_back(x);
    system.residual<Jet<double>>(state, phi);
    int row = 0;
    for (const Constraint& c : m.constraints)
      for (int r = 0; r < rows(c); ++r) {
        if (c.left_out >> r & 1) continue;
        EXPECT_NEAR(phi[row].value, (1 - time) * c.initial_residual[r], 1e-12);
        EXPECT_NEAR(phi[row].first, -c.initial_residual[r], 1e-12);
        EXPECT_NEAR(phi[row].second, 0, 1e-11);
        ++row;
      }
  }
}

}  // namespace
}  // namespace desmo::start_from_rough_drawing_test
