// The norm that the tolerance is on: independent of units, local, never divided by nothing.

#include "formulations/model/magnitudes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "cases/generators/cases.h"
#include "formulations/constraints/constraints.h"
#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/mechanisms.h"

namespace desmo::magnitudes_test {
namespace {

/// The same mechanism with its lengths in another unit: what is a length, and constants by the
/// dimension of their equation.
Model in_unit(Model m, double unit) {
  const auto stretch = [&](const Entity& e, std::vector<double>& values) {
    if (e.kind == EntityKind::point || e.kind == EntityKind::distance)
      for (int i = e.first; i < e.first + e.size; ++i) values[i] *= unit;
  };
  for (const Entity& e : m.entities) stretch(e, e.fixed ? m.fixed_values : m.estimate);
  for (Constraint& c : m.constraints) {
    const std::string_view name = constraint_kind_name(c.kind);
    const auto has = [&](const char* start) { return name.starts_with(start); };
    const bool of_point = m.entities[c.operands.front()].kind == EntityKind::point;
    const double by = has("length") ? unit * unit
                      : has("projection") || has("planar_angle") || has("offset") ||
                              (has("rigid") && of_point) || has("planar_point_by_vector")
                          ? unit
                          : 1;
    for (Derived& constant : c.constants) constant = constant * by;
  }
  return m;
}

double weight(const Model& m, const std::string& constraint, int row = 0) {
  for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
    if (m.constraints[c].name == constraint) return 1 / Magnitudes(m).of({c, row});
  ADD_FAILURE() << "no constraint " << constraint;
  return NAN;
}

/// Points a and b with ‖b − a‖ = length, b found by the constraint and an x of its own.
Model rod(double length, double from = 0) {
  Model m;
  m.name = "rod";
  const GroupId g = m.add_group("rod", {"rod"});
  const EntityId a = m.add_fixed(EntityKind::point, "a", std::array{from, 0.0});
  const EntityId b = m.add(EntityKind::point, "b", std::array{from + length, 0.0}, g);
  m.add({"length", kind_index<Length<2>>(), {a, b}, {length * length}, g});
  return m;
}

TEST(Magnitudes, OfALengthIsItsSquare) {
  for (const double length : {1.0, 0.3, 6.0, 1e-9, 1e9})
    for (const double from : {0.0, 1.0, 1e3 * length})
      EXPECT_NEAR(1 / weight(rod(length, from), "length") / (length * length), std::sqrt(8.0), 1e-6)
          << length << " from " << from;
}

TEST(Magnitudes, AreNeverNothing) {
  for (const double x : {0.0, 1e-150, 1e150, std::numeric_limits<double>::quiet_NaN()}) {
    Model m = rod(1);
    m.estimate[0] = x;
    const double w = weight(m, "length");
    EXPECT_TRUE(w > 0 && std::isfinite(w)) << x << ": " << w;
  }
  Model m;  // a distance that starts at nothing, between points of a link of length 2
  m.name = "telescope";
  const GroupId g = m.add_group("g", {"link"});
  const EntityId a = m.add_fixed(EntityKind::point, "a", std::array{0.0, 0.0});
  const EntityId b = m.add(EntityKind::point, "b", std::array{0.0, 0.0}, g);
  const EntityId c = m.add(EntityKind::point, "c", std::array{2.0, 0.0}, g);
  const EntityId s = m.add(EntityKind::distance, "s", std::array{0.0}, g);
  m.add({"link", kind_index<Length<2>>(), {b, c}, {4}, g});
  m.add({"stroke", kind_index<Distance<2>>(), {a, b, s}, {}, g});
  const double w = weight(m, "stroke");
  EXPECT_GT(w, 1 / (2.0 * 2.0));    // sharper than a link's …
  EXPECT_LT(w, 1e4 / (2.0 * 2.0));  // … but not beyond what rounding lets it meet
}

TEST(Magnitudes, AreLocal) {
  const Model few = four_bar_model(3), many = four_bar_model(300);
  for (const char* name : {"dyad2/coupler", "dyad2/rocker"})
    for (std::size_t c = 0; c < few.constraints.size(); ++c)
      if (few.constraints[c].name.starts_with(name)) {
        EXPECT_EQ(Magnitudes(few).of({static_cast<int>(c), 0}),
                  Magnitudes(many).of({static_cast<int>(c), 0}))
            << few.constraints[c].name;
      }
}

TEST(Magnitudes, FollowTheUnitByThePowerOfTheEquation) {
  for (const Model& m : {truck_model(1), four_bar_model(2)}) {
    const Model other = in_unit(m, 8);  // a power of two: no rounding
    const Magnitudes as_is(m), scaled(other);
    for (int c = 0; c < static_cast<int>(m.constraints.size()); ++c)
      for (int row = 0; row < rows(m.constraints[c]); ++row) {
        const double power = std::log2(scaled.of({c, row}) / as_is.of({c, row})) / 3;
        EXPECT_NEAR(power, std::round(power), 1e-9) << m.constraints[c].name;
        EXPECT_GE(power, -1e-9);
        EXPECT_LE(power, 2 + 1e-9);
      }
  }
}

// ---- what rounding leaves ----

double rounding(const Model& m, std::size_t group) {
  return Magnitudes(m).rounding(make_partition(m, Partition::group)[group]);
}

TEST(Rounding, GrowsWithTheDistanceFromTheOrigin) {
  const double at_origin = rounding(rod(1), 0), far = rounding(rod(1, 1e6), 0);
  EXPECT_GT(at_origin, std::numeric_limits<double>::epsilon() / 4);
  EXPECT_LT(at_origin, 4 * std::numeric_limits<double>::epsilon());
  // A unit in the last place of 1e6, from −1/2 to 1/2 of it.
  EXPECT_GT(far, 1e5 * at_origin);
  EXPECT_LT(far, 1e-9);
  EXPECT_NEAR(rounding(rod(1e9, 1e15), 0) / far, 1, 1e-9);  // whatever the unit is
}

TEST(Rounding, RaisesNoToleranceOfTheCases) {
  for (const Case& c : cases()) {
    const Model m = make_model(make_scene(c, c.sizes.back()));
    for (const Variant& v : variants())
      if (v.evaluation == Evaluation::automatic && v.algebra == "klu") {
        EXPECT_NEAR(make_formulation(v, m)->tolerance(), Settings{}.tolerance, 1e-20)
            << c.name << ", " << v.id;
      }
  }
}

/// A residual of 1e-12 is far below a unit in the last place of where the chain ends.
TEST(Rounding, OfALongChainIsSaidAndNoFailure) {
  const Model m = four_bar_model(3000);
  for (const char* id : {"global_automatic_klu", "group_automatic_eigen", "block_symbolic_inlined",
                         "group_symbolic_explicit"}) {
    const auto f = make_formulation(find_variant(id), m),
               coarse = make_formulation(find_variant(id), m, {.tolerance = 1e-6});
    EXPECT_GT(f->tolerance(), 1e-12) << id;
    EXPECT_LT(f->tolerance(), 1e-9) << id;
    for (int k = 0; k <= 5; ++k) {
      const Summary s = f->step(0.02 * k);
      ASSERT_TRUE(s.ok()) << id << ": " << describe(s, m);
      EXPECT_LE(s.residual, f->tolerance());
      EXPECT_LE(s.iterations, coarse->step(0.02 * k).iterations + 3) << id;
    }
  }
}

EVERY_VARIANT(Units);

/// The same mechanism in nanometres and in gigametres takes the same iterations to the same
/// relative answers.
TEST_P(Units, ChangeNeitherIterationsNorRelativeErrors) {
  const Model m = four_bar_model(4);
  for (const double unit : {1e-9, 1e9}) {
    const Model other = in_unit(m, unit);
    const auto f = make_formulation(GetParam(), m), g = make_formulation(GetParam(), other);
    for (int k = 0; k <= 20; ++k) {
      const Summary a = f->step(0.02 * k), b = g->step(0.02 * k);
      ASSERT_TRUE(a.ok() && b.ok()) << unit << ": " << describe(b, other);
      EXPECT_EQ(a.iterations, b.iterations) << unit;
      EXPECT_NEAR(a.residual, b.residual, 1e-13 + 0.1 * a.residual) << unit;
    }
    for (const Entity& e : m.entities)
      for (int i = e.first; !e.fixed && i < e.first + e.size; ++i) {
        const double by = e.kind == EntityKind::point ? unit : 1;
        EXPECT_NEAR(g->q()[i] / by, f->q()[i], 1e-11) << unit << ", " << e.name;
        EXPECT_NEAR(g->qdd()[i] / by, f->qdd()[i], 1e-8) << unit << ", " << e.name;
      }
  }
}

}  // namespace
}  // namespace desmo::magnitudes_test
