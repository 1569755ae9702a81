// Unknowns in explicit order: what the analysis finds, what the code watches, and what it keeps.

#include <gtest/gtest.h>

#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <utility>

#include "cases/extremes/rows.h"
#include "cases/generators/cases.h"
#include "formulations/motion/internals.h"
#include "formulations/parts/explicit_part.h"
#include "tests/contains.h"
#include "tests/discard.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::explicit_test {
namespace {

/// Returns the comment on its order above the code of every type, by the name of its kernel.
const std::map<std::string, std::string>& orders() {
  static const std::map<std::string, std::string> all = [] {
    constexpr std::string_view begin = "namespace ", comment = "//";
    std::map<std::string, std::string> result;
    for (const char* set : {"cases", "library"}) {
      std::ifstream file(std::string(DESMO_KERNELS "/") + set + "_explicit_kernels.cpp");
      std::string name;
      for (std::string line; std::getline(file, line);) {
        if (line.starts_with(begin))
          name = line.substr(begin.size(), line.find(" {") - begin.size());
        if (line.starts_with(comment) && !name.empty()) result[name] += line + '\n';
      }
    }
    return result;
  }();
  return all;
}

int core_size(const std::string& order) {
  const std::size_t at = order.find("core of ");
  return at == std::string::npos ? 0 : std::stoi(order.substr(at + 8));
}

TEST(ExplicitOrder, LeavesACoreOfTwoInTheAxleAndNoneInWhatHangsOnIt) {
  EXPECT_EQ(core_size(orders().at("truck_suspension_sg_i")), 2);
  EXPECT_EQ(core_size(orders().at("truck_suspension_sg_ii")), 0);
  EXPECT_EQ(core_size(orders().at("truck_suspension_sg_iv")), 0);
  EXPECT_EQ(core_size(orders().at("four_bar_sg_i_1")), 0);
}

TEST(ExplicitOrder, RecognisesWhatIsWorthKnowingAsOne) {
  const std::pair<const char*, const char*> definitions[] = {
      {"four_bar_sg_i_1", "C.x, C.y: two circles"},
      {"four_bar_sg_i_1", "psi: angle ("},
      {"truck_suspension_sg_i", "x2.x, x2.y, x2.z: normal of two"},
      {"truck_suspension_sg_ii", "B6.x, B6.y, B6.z: sphere and planes"},
      {"truck_suspension_sg_ii", "phi6: angle modulo half a turn"},
      {"truck_suspension_sg_iv", "s10: direction and length"},
      {"truck_suspension_sg_iv", "n10.x, n10.y, n10.z: normal of two again"}};
  for (const auto& [type, definition] : definitions) EXPECT_CONTAINS(orders().at(type), definition);
}

TEST(ExplicitOrder, TearsNoMoreThanTheFreedomsOfAPlatform) {
  for (const auto& [name, order] : orders()) EXPECT_LE(core_size(order), 6) << order;
  EXPECT_GT(orders().size(), 90u);
}

const ExplicitPart& part(const Formulation& f, std::size_t i) {
  return dynamic_cast<const ExplicitPart&>(*parts_of(f)[i].solver);
}

TEST(GeneratedCode, NeedsNoFallbackOnTheCases) {
  for (const char* id : {"group_symbolic_inlined", "block_symbolic_inlined",
                         "group_symbolic_explicit", "block_symbolic_explicit"})
    for (const Case& c : cases()) {
      const Model m = make_model(c.with_units(2));
      const auto f = formulated(id, m);
      Discard observer;
      ASSERT_TRUE(f->run(time_grid(3, 0.01), {}, observer).ok());
      EXPECT_EQ(part_counts(*f).fallbacks, 0) << c.name;
      for (const auto& p : parts_of(*f)) EXPECT_TRUE(p.as_named);
    }
}

TEST(Explicit, IteratesOnCoresOnly) {
  const Model four_bar = four_bar_model(3), truck = truck_model(1);
  const auto closed = formulated("group_symbolic_explicit", four_bar),
             torn = formulated("group_symbolic_explicit", truck);
  ASSERT_TRUE(closed->assemble(0).ok() && torn->assemble(0).ok());
  const Summary without = closed->step(0.01), with = torn->step(0.01);
  EXPECT_EQ(without.iterations, 0);
  EXPECT_GE(with.iterations, 1);
  EXPECT_LE(with.iterations, 4);
  EXPECT_LT(without.residual, 1e-10);
  EXPECT_LT(with.residual, 1e-10);
}

/// Products of lengths over- or underflow where these are no nearer to 1 than double precision is
/// wide. Answers stay right, whether the code solves in a unit of its own or a pivoting part does.
TEST(Explicit, IsRightHoweverLargeOrSmallLengthsAre) {
  const auto in_unit = [](double unit) {
    return make_model(
        extremes::case_of("", extremes::usual_chain(3, 1, unit), 1, {0, 0.05, 61}).scene);
  };
  const Model usual = in_unit(1);
  for (const char* id : {"group_symbolic_explicit", "group_symbolic_explicit/lanes:4"})
    for (const double unit : {0x1p-498, 0x1p498}) {
      const Model m = in_unit(unit);
      const auto f = formulated(id, m), expected = formulated(id, usual);
      Discard observer;
      ASSERT_TRUE(f->run({0, 0.05, 61}, {}, observer).ok() &&
                  expected->run({0, 0.05, 61}, {}, observer).ok());
      for (const Entity& e : m.entities)
        for (int i = e.first; i < e.first + e.size && !e.fixed; ++i)
          EXPECT_NEAR(f->qdd()[i] / (e.kind == EntityKind::point ? unit : 1), expected->qdd()[i],
                      1e-11)
              << e.name;
    }
}

/// At the last instant coupler and rocker are nearly in line. The square of the sine of their angle
/// is 1.1e-9 there, a ninth of what the code accepts, and 2e-7 at the instant before. The table of
/// extremes says whether accuracy suffers.
TEST(Explicit, LeavesNearlySingularPositionsToPivoting) {
  const DyadChain chain = extremes::one_dyad(2, std::numbers::pi - 1e-2, 6, 5, 3 + 1e-9);
  const Scene scene = extremes::case_of("", chain, 1e-2 - 1e-5, {0, 0.05, 21}).scene;
  const Model m = make_model(scene);
  const auto f = formulated("group_symbolic_explicit", m);
  Discard observer;
  ASSERT_TRUE(f->run(scene.grid, {}, observer).ok());
  EXPECT_EQ(part_counts(*f).fallbacks, 1);
}

TEST(Explicit, KeepsTheBranchOfTheEstimateHoweverLargeTheStep) {
  for (const double side : {+1.0, -1.0}) {
    Model m = four_bar_model(1);
    const int c = m.entities[m.find("dyad1/C")].first, b = m.entities[m.find("crank/B")].first;
    m.estimate[c + 1] *= side;
    m.estimate[m.entities[m.find("dyad1/psi")].first] *= side;
    const auto f = formulated("group_symbolic_explicit", m);
    ASSERT_TRUE(f->assemble(0).ok());
    const auto branch = part(*f, 1).branches();
    ASSERT_EQ(branch.size(), 1u);
    const double at_start = branch[0];
    for (int i = 1; i <= 40; ++i) {  // of 1.7 rad each
      ASSERT_TRUE(f->step(1.7 * i).ok());
      const double bx = f->q()[b], by = f->q()[b + 1], x = f->q()[c], y = f->q()[c + 1];
      const double area = (6 - bx) * (y - by) - (0 - by) * (x - bx);
      EXPECT_GT(side * area, 0) << i;
    }
    EXPECT_EQ(part(*f, 1).branches()[0], at_start);
    EXPECT_EQ(part(*f, 1).counts().branch_changes, 0);
  }
}

/// Explicit code does not evaluate the driver's sine so far away, and nothing is lost.
TEST(Explicit, LeavesAnglesFarAwayToOthers) {
  const Model m = four_bar_model(2);
  const auto f = formulated("group_symbolic_explicit", m),
             g = formulated("group_automatic_eigen", m);
  for (const double t : {3e6, 3e6 + 0.01, 3e6 + 0.02}) {
    ASSERT_TRUE(f->step(t).ok() && g->step(t).ok());
    EXPECT_LT(max_difference(f->q(), g->q()), 1e-9);
  }
  EXPECT_GT(part_counts(*f).fallbacks, 0);
}

}  // namespace
}  // namespace desmo::explicit_test
