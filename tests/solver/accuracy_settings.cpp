// The settings that trade speed for accuracy: each does what theory says of it, on every
// formulation that offers it, and none accepts what does not meet the tolerance.

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <cmath>
#include <deque>
#include <string>
#include <utility>
#include <vector>

#include "formulations/algebra/blas.h"
#include "formulations/motion/diagnosis.h"
#include "formulations/motion/internals.h"
#include "formulations/parts/profile.h"
#include "formulations/verification/reference/reference.h"
#include "tests/dead_point.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/mechanisms.h"

namespace desmo::accuracy_settings_test {
namespace {

/// Evaluates ‖Φ‖₂ of all groups of a mechanism, each equation over its magnitude.
class WeightedResidual {
 public:
  explicit WeightedResidual(const Model& m) {
    const Magnitudes magnitudes(m);
    for (const PartDefinition& group : make_partition(m, Partition::group))
      if (!group.constant) groups_.emplace_back(m, group, magnitudes);
  }

  double of(const Formulation& f) const {
    double sum = 0;
    for (const DenseGroup& g : groups_)
      sum += g.weights().cwiseProduct(g.residual(stepping_of(f).state().q)).squaredNorm();
    return std::sqrt(sum);
  }

 private:
  std::deque<DenseGroup> groups_;  // which stay where they are
};

class AccuracySettings : public EveryVariant {
 protected:
  // More threads wait for each other where matrices are this small.
  AccuracySettings() { set_blas_threads(1); }
};

/// Steps far too long for old factors, and a walk into a dead point: what is accepted meets the
/// tolerance, and where Newton's method gets through, so do old factors.
TEST_P(AccuracySettings, NoOldFactorsEndAboveTheTolerance) {
  const Settings settings{.tolerance = 1e-11, .max_iterations = 50};
  for (const bool to_the_dead_point : {false, true}) {
    const Model m = to_the_dead_point ? locking_four_bar() : truck_model(1);
    const WeightedResidual weighted_residual(m);
    for (const double h : {0.003, 0.02, 0.1, 0.45}) {
      if (DESMO_SANITIZED && h < (to_the_dead_point ? 0.02 : 0.1)) continue;
      // Newton's method takes the same steps for all settings. So long a motion of short steps is
      // for the way to the dead point.
      const double end = h < 0.02 && !to_the_dead_point ? 0.3 : 1.2;
      std::vector<bool> possible;
      const auto newton = formulated(GetParam().id, m, settings);
      for (int i = 0; i <= static_cast<int>(end / h); ++i)
        possible.push_back(newton->step(h * i).ok());
      for (const std::string suffixes :
           {"/jacobian:step", "/guess:hermite5/jacobian:step", "/guess:linear/jacobian:step"}) {
        const bool guesses = suffixes.starts_with("/guess:");
        if (guesses && h < 0.02) continue;  // short steps begin near their solutions anyway
        const std::string id = offered_id(suffixes);
        if (id.empty()) continue;
        const auto f = formulated(id, m, settings);
        bool solved = true;
        for (std::size_t i = 0; i < possible.size(); ++i) {
          const Summary s = f->step(h * i);
          if (solved && possible[i]) {
            EXPECT_TRUE(s.ok()) << id << " " << h * i << ": " << describe(s, m);
          }
          solved = s.ok() && possible[i];
          if (!s.ok()) continue;
          EXPECT_LT(s.residual, settings.tolerance);
          // Rounding of coordinates of a few metres, and no more, beside what was accepted.
          EXPECT_LT(weighted_residual.of(*f), settings.tolerance + 1e-14) << id << " " << h * i;
        }
      }
    }
  }
}

/// A motion of which every twentieth instant is known in quadruple precision.
struct KnownMotion {
  Model m;
  TimeGrid grid{0, 0.01, DESMO_SANITIZED ? 21 : 101};
  std::vector<ReferenceInstant> reference;

  explicit KnownMotion(Model model) : m(std::move(model)) {
    std::vector<double> times;
    for (int i = 0; i < grid.instants; i += 20) times.push_back(grid.time(i));
    reference = reference_solution(m, times, Precision::quadruple);
  }
};

const std::vector<KnownMotion>& known_motions() {
  static const std::vector<KnownMotion> motions = [] {
    std::vector<KnownMotion> all;
    all.emplace_back(truck_model(1));
    all.emplace_back(four_bar_model(9));
    return all;
  }();
  return motions;
}

TEST_P(AccuracySettings, AgreeWithTheReference) {
  const std::pair<const char*, double> changes[] = {{"/jacobian:step", 1},
                                                    {"/guess:hermite5/jacobian:step", 1},
                                                    {"/iterations:3", 1},
                                                    {"/guess:hermite5/iterations:2", 1},
                                                    {"/tolerance:1e-6", 1e5}};
  for (const auto& [m, grid, reference] : known_motions()) {
    const double size = m.name == "four_bar" ? 6 : 1;  // of a body
    for (const auto& [suffixes, loosened] : changes) {
      const std::string id = offered_id(suffixes);
      if (id.empty()) continue;
      const auto f = formulated(id, m);
      for (int i = 0; i < grid.instants; ++i) {
        const Summary s = f->step(grid.time(i));
        ASSERT_TRUE(s.ok()) << id << " on " << m.name << ": " << describe(s, m);
        if (i % 20 != 0) continue;
        const ReferenceInstant& r = reference[i / 20];
        EXPECT_LT(max_difference(f->q(), r.q), 1e-9 * loosened * size) << id << " on " << m.name;
        EXPECT_LT(max_difference(f->qd(), r.qd), 1e-8 * loosened * size) << id << " on " << m.name;
        EXPECT_LT(max_difference(f->qdd(), r.qdd), 1e-7 * loosened * size)
            << id << " on " << m.name;
      }
    }
  }
}

TEST_P(AccuracySettings, WorkAtEveryLevel) {
  const Model m = truck_model(1);
  const auto plain = formulated(GetParam().id, m);
  ASSERT_TRUE(plain->assemble(0).ok());
  for (const char* suffixes : {"/jacobian:step", "/guess:hermite5/jacobian:step"}) {
    const std::string id = offered_id(suffixes);
    if (id.empty()) continue;
    const auto f = formulated(id, m);
    int i = 0;
    for (const Level level : {Level::acceleration, Level::position, Level::position,
                              Level::velocity, Level::acceleration, Level::acceleration}) {
      ASSERT_TRUE(f->step(0.01 * i, level).ok()) << id;
      ASSERT_TRUE(plain->step(0.01 * i++).ok());
      EXPECT_LT(max_difference(f->q(), plain->q()), 1e-9) << id;
      if (level >= Level::velocity) {
        EXPECT_LT(max_difference(f->qd(), plain->qd()), 1e-8) << id;
      }
      if (level >= Level::acceleration) {
        EXPECT_LT(max_difference(f->qdd(), plain->qdd()), 1e-7) << id;
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Table, AccuracySettings, testing::ValuesIn(tested_variants()),
                         EveryVariant::name);

long factorisations(const std::string& id, const Model& m) {
  const Configuration c = parse_id(id);
  Profile profile;
  const auto f = make_profiled_formulation(*c.variant, m, c.settings, profile);
  EXPECT_TRUE(f->assemble(0).ok());
  const long before = profile.calls[static_cast<int>(Phase::factorisation)];
  for (int i = 1; i <= 100; ++i) EXPECT_TRUE(f->step(0.01 * i).ok());
  return profile.calls[static_cast<int>(Phase::factorisation)] - before;
}

TEST(Factorisations, AreAsManyAsTheSettingsSay) {
  const Model m = truck_model(1);
  const std::string klu = "global_automatic_klu";
  EXPECT_GT(factorisations(klu, m), 300);
  EXPECT_EQ(factorisations(klu + "/iterations:2", m), 300);
  // The second step has no instant before last, and may need another.
  EXPECT_NEAR(factorisations(klu + "/guess:hermite5/jacobian:step", m), 101, 1);
}

}  // namespace
}  // namespace desmo::accuracy_settings_test
