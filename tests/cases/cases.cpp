#include "cases/generators/cases.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>

#include "formulations/constraints/constraints.h"
#include "formulations/model/misfit.h"
#include "tests/contains.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"
#include "tests/refusal.h"

namespace desmo::cases_test {
namespace {

struct Counts {
  int points = 0, vectors = 0, scalars = 0;
  bool operator==(const Counts&) const = default;
};

Counts entity_counts(const Model& m, const Group& g) {
  Counts c;
  for (const EntityId e : g.entities) {
    const EntityKind kind = m.entities[e].kind;
    ++(kind == EntityKind::point ? c.points : kind == EntityKind::vector ? c.vectors : c.scalars);
  }
  return c;
}

TEST(TruckSuspension, HasThePapersEntitiesInEachGroup) {
  const Model m = truck_model(2);
  const Counts of_axle[] = {{8, 9, 2}, {3, 5, 1}, {3, 5, 1}, {2, 5, 1}, {2, 5, 1}};
  for (int g = 0; g < 10; ++g)
    EXPECT_EQ(entity_counts(m, m.groups[1 + g]), of_axle[g % 5]) << m.groups[1 + g].name;
}

TEST(Cases, HaveThePapersSizes) {
  for (const Case& c : cases()) {
    EXPECT_EQ(c.sizes, (std::vector{114, 225, 336, 447, 558})) << c.name;
    for (const int n : c.sizes) EXPECT_EQ(make_model(make_scene(c, n)).coordinates(), n) << c.name;
  }
  EXPECT_EQ(make_model(make_scene(find_case("four_bar"), 1002)).coordinates(), 1002);
}

TEST(Cases, RefuseWhatDoesNotExist) {
  EXPECT_THROW(find_case("five_bar"), std::invalid_argument);
  EXPECT_THROW(make_scene(find_case("truck_suspension"), 115), std::invalid_argument);
  EXPECT_THROW(make_scene(find_case("four_bar"), 3), std::invalid_argument);
  EXPECT_THROW(make_scene(find_case("four_bar"), -3), std::invalid_argument);
  EXPECT_THROW(four_bar(0), std::invalid_argument);
  EXPECT_THROW(truck_suspension(-1), std::invalid_argument);
}

TEST(Cases, TimeGridIncludesBothEnds) {
  const TimeGrid g = time_grid(30, 0.01);
  EXPECT_EQ(g.instants, 3001);
  EXPECT_DOUBLE_EQ(g.time(3000), 30);
  EXPECT_EQ((TimeGrid{-1, 0.1, 21}.time(10)), 0);  // 10 steps rounded, not with the sum
  EXPECT_THROW(time_grid(-1, 0.01), std::invalid_argument);
  EXPECT_THROW(time_grid(1, 0), std::invalid_argument);
  EXPECT_THROW(time_grid(0.001, 0.01), std::invalid_argument);
  EXPECT_THROW(time_grid(1e300, 1e-300), std::invalid_argument);
  EXPECT_THROW(time_grid(NAN, 0.01), std::invalid_argument);
}

TEST(FourBar, StartsFromTheDesignsEstimate) {
  const Model m = four_bar_model(2);
  const auto at = [&](const char* name) { return m.value(name, m.estimate); };
  EXPECT_DOUBLE_EQ(at("crank/theta"), std::acos(0.5));
  EXPECT_DOUBLE_EQ(at("dyad2/C.x"), 9);
  EXPECT_DOUBLE_EQ(at("dyad2/C.y"), 5);
  EXPECT_DOUBLE_EQ(at("dyad2/psi"), 2);
  EXPECT_DOUBLE_EQ(at("dyad2/D.x"), 12);
}

TEST(TruckSuspension, NominalPositionSatisfiesEveryEquation) {
  // The drivers start elsewhere, but all that the design calls nominal must fit together.
  const Model m = truck_model(2);
  const std::vector<double> state = state_at_estimate(m).q;
  for (const Constraint& c : m.constraints)
    for (const double r : residual_of(m, c, state)) EXPECT_NEAR(r, 0, 1e-15) << c.name;
}

TEST(TruckSuspension, MotionIsTheDesigns) {
  const Model m = truck_model(3);
  const double t = 1.234, a = 2, w = 2 * std::acos(-1.0);
  const auto zR = sample(m.drivers[5].motion, t);
  EXPECT_EQ(m.entities[m.drivers[5].coordinate].name, "axle3/zR");
  EXPECT_NEAR(zR.position, 0.5 + 0.05 * std::sin(w * 1.3 * t + 0.7 - 0.3 * a), 1e-15);
  EXPECT_NEAR(zR.velocity, 0.05 * w * 1.3 * std::cos(w * 1.3 * t + 0.7 - 0.3 * a), 1e-14);
  EXPECT_NEAR(zR.acceleration, -0.05 * w * w * 1.69 * std::sin(w * 1.3 * t + 0.7 - 0.3 * a), 1e-13);
}

constexpr std::array<double, 2> zero{};

/// Returns what validate() says of a model with one group, to which `build` adds entities.
std::string said_of(const auto& build) {
  Model m;
  m.name = "broken";
  m.add_group("only", {"1"});
  build(m);
  return refusal([&] { validate(m); });
}

TEST(Model, ThatIsWrongIsRefused) {
  EXPECT_CONTAINS(said_of([](Model& m) { m.add(EntityKind::point, "p", zero, 0); }),
                  "'only': 0 equations for 2 unknowns (under-constrained)");
  EXPECT_CONTAINS(
      said_of([](Model& m) {
        const EntityId p = m.add(EntityKind::point, "p", zero, 0),
                       o = m.add_fixed(EntityKind::point, "o", zero);
        for (int i = 0; i < 3; ++i)
          m.add({"length " + std::to_string(i), kind_index<Length<2>>(), {o, p}, {1}, 0});
      }),
      "over-constrained");
  EXPECT_CONTAINS(said_of([](Model& m) {
                    for (int i = 0; i < 2; ++i) m.add_fixed(EntityKind::point, "p", zero);
                  }),
                  "'p'");
  EXPECT_CONTAINS(said_of([](Model& m) {
                    m.add_fixed(EntityKind::point, "p", std::array<double, 2>{0, INFINITY});
                  }),
                  "not finite");
}

TEST(Model, RefusesWrongOperandsAndDrivers) {
  Model m;
  m.add_group("only", {"1"});
  const EntityId p = m.add(EntityKind::point, "p", zero, 0);
  const EntityId s = m.add(EntityKind::angle, "s", std::array{0.0}, 0);
  EXPECT_THROW(m.add({"length", kind_index<Length<2>>(), {p, s}, {1}, 0}), std::invalid_argument);
  EXPECT_THROW(m.add({"length", kind_index<Length<2>>(), {p, p}, {NAN}, 0}), std::invalid_argument);
  EXPECT_THROW(m.drive(p, Polynomial{}), std::invalid_argument);
  EXPECT_THROW(m.find("q"), std::invalid_argument);
}

}  // namespace
}  // namespace desmo::cases_test
