// The model of a part depends neither on the size of its mechanism nor on the other parts of it.

#include <gtest/gtest.h>

#include <numbers>

#include "cases/extremes/rows.h"
#include "formulations/model/characteristic_lengths.h"
#include "formulations/model/scales.h"
#include "formulations/variants.h"
#include "tests/modelling/common.h"

namespace desmo::sizes_test {
namespace {

constexpr double start = std::numbers::pi / 3;

ModellingResult modelled(const ExtremeCase& c) {
  return model_mechanism(c.scene.mechanism, c.scene.motions);
}

ExtremeCase chain_of(double scale, int dyads = 2) {
  return extremes::case_of("", extremes::usual_chain(dyads, start, scale), 1, {0, 0.1, 5});
}

/// Two chains in one mechanism.
ExtremeCase both(double small, double large) {
  DyadChain a = extremes::usual_chain(2, start, small), b = extremes::usual_chain(2, start, large);
  a.prefix = "a/";
  b.prefix = "b/";
  const Motion turning = Polynomial{{start, 1}};
  return extremes::case_of("", {a, b}, {turning, turning}, {0, 0.1, 5});
}

TEST(Sizes, OfMechanismsFromAtomsToGalaxiesMakeTheSameModel) {
  const Model usual = modelled(chain_of(1)).model;
  for (const double scale : {1e-150, 1e-30, 1e-9, 1e9, 1e30, 1e150}) {
    const Model m = modelled(chain_of(scale)).model;
    ASSERT_EQ(m.constraints.size(), usual.constraints.size()) << scale;
    for (std::size_t c = 0; c < m.constraints.size(); ++c) {
      EXPECT_EQ(m.constraints[c].name, usual.constraints[c].name) << scale;
      EXPECT_EQ(m.constraints[c].left_out, usual.constraints[c].left_out) << scale;
    }
  }
}

TEST(Sizes, WhoseSquaresOverflowOrVanishAreRefused) {
  for (const double scale : {1e-160, 1e-200, 1e160, 1e200}) {
    const Scene scene = chain_of(scale).scene;
    expect_refused(scene.mechanism, scene.motions,
                   {"body 'crank'", "square", "choose another unit of length"});
  }
}

TEST(Sizes, OfOnePartSayNothingOfAnother) {
  for (const double small : {1e-9, 1e-30, 1e-100}) {
    const Model m = modelled(both(small, 1e9)).model;
    EXPECT_EQ(m.structural_groups(), 6) << small;
    const auto f = make_formulation(find_variant("group_automatic_eigen"), m);
    EXPECT_TRUE(f->assemble(0).ok()) << small;
  }
}

TEST(CharacteristicLengths, AreThoseOfTheBodiesAbout) {
  const Model m = modelled(both(1e-9, 1e9)).model;
  const CharacteristicLengths lengths(m);
  EXPECT_DOUBLE_EQ(lengths.of(m.find("a/crank/B")), 6e-9);
  EXPECT_DOUBLE_EQ(lengths.of(m.find("b/dyad2/C")), 6e9);
  for (const Constraint& c : m.constraints)
    EXPECT_NEAR(lengths.of(c), c.name.starts_with("a/") ? 6e-9 : 6e9, 1e-3 * lengths.of(c))
        << c.name;
}

/// A slider-crank that far from the origin, with components of its points and, if `estimate` is not
/// 0, a stroke that starts there.
Model slider_crank_at(double away, double estimate = 0) {
  Sketch d("slider_crank", 2);
  const int A = d.ground_point("A", {away, away, 0}), B = d.point("B", {away + 1, away, 0}),
            C = d.point("C", {away + 4, away, 0}), x = d.ground_vector("x", {1, 0, 0});
  d.bodies({{"crank", {A, B}}, {"rod", {B, C}}});
  const int slider = d.body("slider", {C}, {x});
  d.joint(JointType::prismatic, Sketch::ground, slider, {A, C}, {x});
  d.angle("theta", line(A, B)).driven = true;
  d.component("Bx", B, 0);
  d.component("Cx", C, 0);
  auto& stroke = d.along("s", A, C, x);
  if (estimate != 0) stroke.estimate = estimate;
  return model_mechanism(d.release_pinned(), turning).model;
}

TEST(Sizes, AreDistancesOfPointsAndNoneFromTheOrigin) {
  for (const double away : {0.0, 1e3, 1e8}) {
    const Model m = slider_crank_at(away);
    EXPECT_EQ(nominal_size(m), 4) << away;
    const CharacteristicLengths lengths(m);
    for (const char* name : {"B", "C", "Bx", "Cx"}) {
      EXPECT_GE(lengths.of(m.find(name)), 1) << name << " at " << away;
      EXPECT_LE(lengths.of(m.find(name)), 4) << name << " at " << away;
    }
    for (const Constraint& c : m.constraints) EXPECT_LE(lengths.of(c), 4) << c.name;
  }
  EXPECT_EQ(nominal_size(slider_crank_at(1e3, 9)), 9);  // a distance larger than the drawing
}

/// At the end of a chain as long as 400,000 links, one link is nothing beside the whole.
TEST(Sizes, OfLongMechanismsDoNotMatter) {
  const ExtremeCase near = chain_of(1, 1);
  Mechanism far = near.scene.mechanism;
  const double away = 6.0 * 400'000;
  for (Mechanism::Point& p : far.points) p.position[0] += away;
  far.points.push_back({"origin", {0, 0, 0}});
  far.bodies.front().points.push_back(static_cast<int>(far.points.size()) - 1);
  const Model m = model_mechanism(far, {Polynomial{{start, 1}}}).model;
  EXPECT_EQ(m.constraints.size(), modelled(near).model.constraints.size());
}

}  // namespace
}  // namespace desmo::sizes_test
