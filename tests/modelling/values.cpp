// Values by their names.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "cases/generators/cases.h"
#include "tests/describing.h"
#include "tests/mechanisms.h"
#include "tests/refusal.h"

namespace desmo::values_test {
namespace {

TEST(Values, OfEveryCoordinateAreFoundByTheNameThatItHas) {
  for (const Model& m : {four_bar_model(2), truck_model(1)}) {
    const std::vector<EntityId> owner = entity_of_coordinate(m);
    std::vector<double> q(m.coordinates());
    for (int i = 0; i < m.coordinates(); ++i) q[i] = 0.5 + i;
    for (int i = 0; i < m.coordinates(); ++i) {
      const std::string name = coordinate_name(m, owner[i], i);
      EXPECT_EQ(m.coordinate(name), i) << name;
      EXPECT_EQ(m.value(name, q), q[i]) << name;
      EXPECT_EQ(m.value(name, q, Level::acceleration), q[i]) << name;
    }
  }
}

TEST(Values, OfWhatIsFixedAreConstantsWithoutRates) {
  const Model m = four_bar_model(2);
  const std::vector<double> q(m.coordinates(), 7);
  EXPECT_EQ(m.value("dyad2/D.x", q), 12);
  EXPECT_EQ(m.value("dyad2/D.x", q, Level::velocity), 0);
  EXPECT_EQ(m.value("dyad2/D.x", q, Level::acceleration), 0);
  EXPECT_EQ(refusal([&] { m.coordinate("dyad2/D.x"); }),
            "four_bar: 'dyad2/D.x' is fixed and no coordinate");
}

TEST(Values, PreferAnEntityOfThatNameToAComponent) {
  Model m;
  const GroupId g = m.add_group("g", {"body"});
  m.add(EntityKind::point, "C", std::array{1.0, 2.0}, g);
  m.add(EntityKind::distance, "C.x", std::array{3.0}, g);
  m.add(EntityKind::point, "a.b", std::array{4.0, 5.0}, g);
  EXPECT_EQ(m.coordinate("C.x"), 2);
  EXPECT_EQ(m.coordinate("C.y"), 1);
  EXPECT_EQ(m.coordinate("a.b.y"), 4);
}

TEST(Values, OfWrongNamesAreRefusedWithNamesThatExist) {
  const Model m = four_bar_model(1);
  for (const char* name : {"", ".", "x", ".x", "crank/B", "crank/B.", "crank/B.z", "crank/B.xy",
                           "crank/B.yx", "crank/theta.x", "crank/b.x"}) {
    const std::string message = refusal([&] { m.coordinate(name); });
    EXPECT_TRUE(message.starts_with("four_bar: there is no coordinate '" + std::string(name)))
        << message;
    EXPECT_NE(message.find("crank/"), message.npos) << message;
  }
  const std::string misspelt = refusal([&] { m.coordinate("crank/b.x"); });
  EXPECT_NE(misspelt.find("did you mean"), misspelt.npos) << misspelt;
  EXPECT_NE(misspelt.find("'crank/B.x'"), misspelt.npos) << misspelt;
  EXPECT_NE(refusal([&] { m.value("crank/B.x", std::array{1.0}); }).find("1 values for"),
            std::string::npos);
}

TEST(Values, OfAFormulationAreThoseOfItsLastInstant) {
  const Model m = make_model(four_bar(1));
  const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
  ASSERT_TRUE(f->assemble(0).ok());
  ASSERT_TRUE(f->step(0.1).ok());
  const double theta = f->value("crank/theta"), rate = f->value("crank/theta", Level::velocity);
  const double length = std::hypot(f->value("crank/B.x"), f->value("crank/B.y"));
  EXPECT_NEAR(f->value("crank/B.x"), length * std::cos(theta), 1e-12);
  EXPECT_NEAR(f->value("crank/B.x", Level::velocity), -length * std::sin(theta) * rate, 1e-12);
  EXPECT_NEAR(f->value("crank/B.x", Level::acceleration), -length * std::cos(theta) * rate * rate,
              1e-12);
  EXPECT_GT(rate, 0);
}

}  // namespace
}  // namespace desmo::values_test
