// Couplings by tables: many at once, and where their tables end.

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <variant>

#include "cases/mechanism/builder.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/everything.h"
#include "tests/lanes_here.h"
#include "tests/load/loading.h"

namespace desmo::load::tables_test {
namespace {

/// Five pins on curved rails, of which tables and motions differ. `longer` has one more knot.
class Rails : public Loading {
 protected:
  static constexpr int count = 5, longer = 4;

  void SetUp() override {
    MechanismBuilder b("rails", 2);
    scene_.motions.clear();
    for (int k = 0; k < count; ++k) {
      const double at = 0.3 * k;
      const auto named = [&](const char* name) { return name + std::to_string(k); };
      const int o = b.point(named("O"), {at, 0}), a = b.point(named("A"), {at - 0.06, 0.08}),
                p = b.point(named("P"), {at + 0.02, 0.1});
      b.carry(MechanismBuilder::ground, {o});
      const int crank = b.body(named("crank"), {o, a}), rod = b.body(named("rod"), {a, p});
      b.joint(Mechanism::JointType::revolute, MechanismBuilder::ground, crank, {o});
      b.joint(Mechanism::JointType::revolute, crank, rod, {a});
      b.component(named("x"), p, 0);
      b.component(named("y"), p, 1).driven = true;
      b.couple(named("rail"), {{2 * k + 1, 1}, {2 * k, 1}});
      scene_.motions.push_back(HarmonicSum{0.105, {{0.02, 3, 0.9 * k}}});
    }
    scene_.mechanism = b.release();
    for (int k = 0; k < count; ++k) {
      const double at = 0.3 * k, bend = 0.0004 * k;
      scene_.mechanism.couplings[k].table = {
          {at, at + 0.01, at + 0.02, at + 0.035 - bend, at + 0.05},
          {0.08, 0.088 + bend, 0.1, 0.112, 0.14}};
    }
    Mechanism::Coupling::Table& table = *scene_.mechanism.couplings[longer].table;
    table.arguments.push_back(table.arguments.back() + 0.01);
    table.values.push_back(0.15);
    scene_.grid = {0, 0.01, 300};
    scene_.request.clear();
    model_ = make_model(scene_);
  }
};

TEST_F(Rails, AreSolvedAtOnceAsOneByOne) {
  KernelTable table;
  const auto one_by_one = made("group_symbolic_explicit", table);
  EXPECT_EQ(std::ssize(parts_of(*one_by_one)), count);
  for (const int lanes : lanes_here()) {
    const std::string id = "group_symbolic_explicit/lanes:" + std::to_string(lanes);
    const auto at_once = made(id, table);
    EXPECT_EQ(parts_of(*at_once).size(), 2u) << id;
    expect_same_motion(*at_once, *one_by_one, scene_.grid, id);
  }
}

/// Outside of a table that does not repeat there is no position: neither an unchecked run nor a
/// checked one delivers any.
TEST(CouplingByTable, HasNoPositionsOutside) {
  Scene scene = read_scene(fs::path(DESMO_SOURCE_DIR) / "tests/load/scenes/curved_rail.scene.json");
  std::get<HarmonicSum>(scene.motions[0]).terms[0].amplitude = 0.05;  // m: the table has 0.035
  const Model model = make_model(scene);
  for (const char* id : {"global_automatic_klu", "group_automatic_lapack"}) {
    const auto f = make_formulation(find_variant(id), model);
    Everything found(scene.grid.instants);
    const Summary summary = f->run(scene.grid, {}, found);
    EXPECT_FALSE(summary.ok()) << id;
    EXPECT_LT(summary.instants, scene.grid.instants) << id;
    EXPECT_NE(describe(summary, model).find("'rail: coupling', which is outside of its table"),
              std::string::npos)
        << describe(summary, model);
    CheckOptions options;
    options.checked = [&](const CheckedInstant& i) {
      EXPECT_TRUE(i.flag || i.instant.q[model.coordinate("x")] <= 0.05 + 1e-10) << id;
    };
    EXPECT_FALSE(run_checked(*f, scene.grid, {}, found, options).ok()) << id;
  }
}

}  // namespace
}  // namespace desmo::load::tables_test
