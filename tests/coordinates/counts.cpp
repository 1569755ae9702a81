// Unknowns of linear systems in each kind of coordinates.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "cases/io/files.h"
#include "cases/mechanism/builder.h"
#include "formulations/formulation.h"
#include "formulations/model/partition.h"
#include "formulations/model/plan.h"
#include "formulations/variants.h"
#include "tests/contains.h"
#include "tests/mechanisms.h"
#include "tests/refusal.h"

namespace desmo::coordinate_counts_test {
namespace {

using Counts = std::vector<int>;

/// Returns the number of unknowns that are not derived, of each moving part that has any.
Counts solved(const Model& m, Partition partition) {
  Counts counts;
  for (const PartDefinition& part : make_partition(m, partition))
    if (const int n = static_cast<int>(part.unknowns.size() - derivations(m, part).size());
        n > 0 && !part.constant)
      counts.push_back(n);
  return counts;
}

TEST(Coordinates, LeaveTheUnknownsOfTheTextbooks) {
  const auto truck = [](Modelling kind, int axles) {
    return make_model(truck_suspension(axles), kind);
  };
  EXPECT_EQ(solved(truck(Modelling::natural, 1), Partition::group), (Counts{39, 19, 19, 16, 16}));
  EXPECT_EQ(solved(truck(Modelling::basis, 1), Partition::group), (Counts{27, 16, 16, 13, 13}));
  // Twelve bodies with seven parameters each, and two declared angles.
  EXPECT_EQ(solved(truck(Modelling::reference, 1), Partition::group), (Counts{28, 15, 15, 14, 14}));
  EXPECT_EQ(solved(truck(Modelling::relative, 1), Partition::group), (Counts{9, 3, 3, 3, 3}));
  for (const int axles : {1, 2}) {
    EXPECT_EQ(solved(truck(Modelling::natural, axles), Partition::global), Counts{109 * axles});
    EXPECT_EQ(solved(truck(Modelling::basis, axles), Partition::global), Counts{85 * axles});
    EXPECT_EQ(solved(truck(Modelling::reference, axles), Partition::global), Counts{86 * axles});
    EXPECT_EQ(solved(truck(Modelling::relative, axles), Partition::global), Counts{21 * axles});
  }
  // The crank, then dyads: in reference coordinates with the angle that they declare.
  const auto chain = [](Modelling kind) {
    return solved(make_model(four_bar(2), kind), Partition::group);
  };
  EXPECT_EQ(chain(Modelling::basis), (Counts{2, 3, 3}));
  EXPECT_EQ(chain(Modelling::reference), (Counts{3, 7, 7}));
  EXPECT_EQ(chain(Modelling::relative), (Counts{2, 2}));
}

TEST(Coordinates, KeepStructuralGroupsAndHideWhatServesTheModel) {
  for (const Scene& scene : library_scenes()) {
    const Model natural = make_model(scene);
    for (const Modelling kind : {Modelling::basis, Modelling::reference, Modelling::relative}) {
      const Model m = make_model(scene, kind);
      EXPECT_EQ(m.modelling, kind);
      ASSERT_EQ(m.groups.size(), natural.groups.size()) << m.name;
      for (std::size_t g = 0; g < m.groups.size(); ++g) {
        EXPECT_EQ(m.groups[g].name, natural.groups[g].name);
        EXPECT_EQ(m.groups[g].bodies, natural.groups[g].bodies);
        for (const EntityId e : m.groups[g].entities) EXPECT_FALSE(m.entities[e].internal);
      }
      const Plan everything = make_plan(m, {});
      for (const Output& output : everything.outputs)
        EXPECT_FALSE(everything.model.entities[output.entity].internal) << m.name;
    }
  }
}

/// Two bodies that hang on nothing but each other: one is free, the other hangs on it.
TEST(Coordinates, HangBodiesOnFreeOnes) {
  const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 1, "mechanism":
    {"format": "desmo-mechanism", "version": 1, "name": "scissors", "dimension": 2,
     "points": {"O": [0, 0], "R": [1, 1], "P": [2, 3], "Q": [3, 0]}, "ground": {"points": ["O"]},
     "bodies": {"a": {"points": ["R", "P"]}, "b": {"points": ["R", "Q"]}},
     "joints": [{"type": "revolute", "bodies": ["a", "b"], "points": ["R"]}],
     "coordinates": {"px": {"component": "P", "axis": "x"}, "py": {"component": "P", "axis": "y"},
                     "qx": {"component": "Q", "axis": "x"}, "qy": {"component": "Q", "axis": "y"}},
     "drivers": ["px", "py", "qx", "qy"]},
    "motion": {"px": {"type": "constant", "value": 2}, "py": {"type": "constant", "value": 3},
               "qx": {"type": "constant", "value": 3}, "qy": {"type": "constant", "value": 0}},
    "time": {"end": 1, "step": 0.1}})",
                                  "scissors", {});
  EXPECT_EQ(solved(make_model(scene, Modelling::relative), Partition::global), Counts{4});
  EXPECT_EQ(solved(make_model(scene, Modelling::reference), Partition::global), Counts{6});
}

/// A point that is drawn off its line by rounding counts as on the line. One that is off by three
/// times the limit of rounding keeps its distance: its joint is cut.
TEST(Coordinates, KeepWhatSlidesBesideItsLineThere) {
  constexpr double rounding = 1e-12 * 5;  // of the size, 3 by 4
  for (const auto& [kind, off] : {std::pair{Modelling::basis, -0.3},
                                  {Modelling::reference, -0.3},
                                  {Modelling::relative, 0.3},
                                  {Modelling::relative, 3 * rounding},
                                  {Modelling::relative, rounding / 3}}) {
    MechanismBuilder builder("beside", 2);
    const int A = builder.point("A", {0, 0, 0}), B = builder.point("B", {0, 4, 0}),
              C = builder.point("C", {3, off, 0});
    const int u = builder.vector("u", {1, 0, 0});
    builder.carry(MechanismBuilder::ground, {A, B}, {u});
    const int slider = builder.body("slider", {C}, {u});
    builder.joint(Mechanism::JointType::prismatic, MechanismBuilder::ground, slider, {A, C}, {u});
    builder.component("x", C, 0).driven = true;
    const Scene scene{"beside", builder.release(), {Polynomial{{3, 1}}}, {0, 0.1, 11}, {}, {}};
    const Model m = make_model(scene, kind);
    const auto f =
        make_formulation(find_variant("group_automatic_lapack"), m, {.coordinates = kind});
    ASSERT_TRUE(f->assemble(0.5).ok());
    EXPECT_NEAR(f->value("C.x"), 3.5, 1e-12);
    EXPECT_NEAR(f->value("C.y"), std::abs(off) > rounding ? off : 0,
                std::min(std::abs(off) / 10, 1e-12))
        << name_of(kind) << ", " << off;
  }
}

/// A strut of two halves that may both spin: neither has a frame.
TEST(Coordinates, KeepHalvesOfAStrutInLine) {
  const Scene scene = parse_scene(R"({"format": "desmo-scene", "version": 1, "mechanism":
    {"format": "desmo-mechanism", "version": 1, "name": "strut", "dimension": 3,
     "points": {"O": [0, 0, 0], "A": [1, 0, 0], "B": [0, 0, 1], "P": [0.5, 0, 0.5], "Q": [0.6, 0, 0.4]},
     "vectors": {"y": [0, 1, 0], "u": {"along": ["B", "P"]}},
     "ground": {"points": ["O", "B"], "vectors": ["y"]},
     "bodies": {"arm": {"points": ["O", "A"], "vectors": ["y"]},
                "cylinder": {"points": ["B", "P"], "vectors": ["u"]},
                "rod": {"points": ["A", "Q"], "vectors": ["u"]}},
     "joints": [{"type": "revolute", "bodies": ["ground", "arm"], "points": ["O"], "vectors": ["y"]},
                {"type": "spherical", "bodies": ["ground", "cylinder"], "points": ["B"]},
                {"type": "spherical", "bodies": ["arm", "rod"], "points": ["A"]},
                {"type": "cylindrical", "bodies": ["cylinder", "rod"], "points": ["P", "Q"], "vectors": ["u"]}],
     "coordinates": {"height": {"component": "A", "axis": "z"}}, "drivers": ["height"]},
    "motion": {"height": {"type": "polynomial", "coefficients": [0, 0.1]}},
    "time": {"end": 1, "step": 0.1}})",
                                  "strut", {});
  for (const Modelling kind : {Modelling::reference, Modelling::relative}) {
    const Model m = make_model(scene, kind);
    const auto f = make_formulation(find_variant("global_automatic_klu"), m, {.coordinates = kind});
    ASSERT_TRUE(f->assemble(0).ok() && f->step(1).ok());
    const double x = f->value("A.x"), z = f->value("A.z") - 1;  // B to A
    EXPECT_NEAR(f->value("Q.x") * z, (f->value("Q.z") - 1) * x, 1e-10);
  }
}

TEST(Coordinates, OfTheModelHaveNamesThatTheMechanismLeaves) {
  Scene scene = four_bar(1);
  Mechanism& mechanism = scene.mechanism;
  const std::string joint = mechanism.joints.front().name;
  for (const char* internal : {"/angle", "/travel"}) {
    mechanism.points.push_back({joint + internal, {0, 0, 0}});
    mechanism.bodies.front().points.push_back(static_cast<int>(mechanism.points.size()) - 1);
  }
  mechanism.points.push_back({mechanism.bodies[1].name + "/x", {1, 0, 0}});
  mechanism.bodies.front().points.push_back(static_cast<int>(mechanism.points.size()) - 1);
  for (const Modelling kind : {Modelling::reference, Modelling::relative})
    EXPECT_NO_THROW(make_model(scene, kind));
}

TEST(Coordinates, OfTheModelAreThoseOfTheSettings) {
  const Model m = make_model(four_bar(1), Modelling::relative);
  const Variant& v = find_variant("group_automatic_lapack");
  EXPECT_CONTAINS(refusal([&] { make_formulation(v, m); }), "other coordinates");
  EXPECT_NO_THROW(make_formulation(v, m, Settings{.coordinates = Modelling::relative}));
  EXPECT_CONTAINS(refusal([&] { require_natural(m); }), "natural coordinates alone");
}

TEST(Derivations, ThatCannotBeAreRefused) {
  Model m = make_model(four_bar(1), Modelling::relative);
  Constraint* derivation = nullptr;
  for (Constraint& c : m.constraints)
    if (c.derives == 0) derivation = &c;
  ASSERT_TRUE(derivation);
  EXPECT_NO_THROW(validate(m));
  derivation->derives = 1;  // not explicit in that
  EXPECT_CONTAINS(refusal([&] { validate(m); }), "cannot derive");
}

}  // namespace
}  // namespace desmo::coordinate_counts_test
