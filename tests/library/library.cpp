// Every mechanism of the library, with every formulation, against its independent solution; the
// independent solutions against themselves.

#include "cases/library/library.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <ostream>
#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "cases/io/files.h"
#include "formulations/model/scales.h"
#include "formulations/modelling/modelling.h"
#include "formulations/variants.h"
#include "tests/every_variant.h"
#include "tests/formulated.h"
#include "tests/library/solutions.h"

namespace desmo {

inline void PrintTo(const LibraryMechanism& l, std::ostream* out) { *out << l.name; }

namespace desmo::library_test {
namespace {

using exact::Quantity;
using exact::Solution;

/// The independent solution at every instant of the scene; the same for all formulations.
const std::vector<Solution>& solutions(const Scene& scene) {
  static std::map<std::string, std::vector<Solution>> known;
  std::vector<Solution>& list = known[scene.mechanism.name];
  const auto at = exact::library_solutions().at(scene.mechanism.name);
  for (int i = static_cast<int>(list.size()); i < scene.grid.instants; ++i)
    list.push_back(at(scene.grid.time(i)));
  return list;
}

/// The largest values of the whole motion at each level, by which errors are judged: for lengths
/// (of which positions: the extent of the mechanism) and for directions and angles (positions: 1).
struct LargestValues {
  PerLevel<double> lengths{0, 0, 0}, others{1, 0, 0};

  LargestValues(const Model& m, const std::vector<Solution>& motion) {
    double low[3], high[3];
    std::fill_n(low, 3, INFINITY);
    std::fill_n(high, 3, -INFINITY);
    for (const Solution& s : motion)
      for (const auto& [name, q] : s) {
        const EntityKind kind = m.entities[m.find(name)].kind;
        for (int i = 0; i < q.size; ++i) {
          for (const Level level : rate_levels) {
            double& scale = (is_length(kind) ? lengths : others)[level];
            scale = std::max(scale, std::abs(q.levels[level][i]));
          }
          if (kind != EntityKind::point) continue;
          low[i] = std::min(low[i], q.levels.position[i]);
          high[i] = std::max(high[i], q.levels.position[i]);
        }
      }
    for (int i = 0; i < 3; ++i) lengths.position = std::max(lengths.position, high[i] - low[i]);
  }

  const PerLevel<double>& of(EntityKind kind) const { return is_length(kind) ? lengths : others; }
};

/// Compares everything that the mechanism's file names, at every instant.
class Comparison final : public Observer {
 public:
  struct Worst {
    double error = 0;  ///< by the scale
    std::string where = "nowhere";
  };

  Comparison(const Model& m, const std::vector<Solution>& motion)
      : m_(m), motion_(motion), scales_(m, motion) {}

  Flow observe(const Instant& instant) noexcept override {
    ++instants;
    for (const auto& [name, q] : motion_[instant.index]) {
      const Entity& e = m_.entities[m_.find(name)];
      if (e.fixed) continue;
      EXPECT_EQ(e.size, q.size) << name;
      const PerLevel<std::span<const double>> found{instant.q, instant.qd, instant.qdd};
      for (const Level level : all_levels)
        for (int i = 0; i < q.size; ++i) {
          double error = found[level][e.first + i] - q.levels[level][i];
          if (level == Level::position && e.kind == EntityKind::angle)
            error = std::remainder(error, 2 * std::numbers::pi);
          if (error == 0) continue;  // also where nothing moves and the scale is 0
          error = larger_error(0, std::abs(error) / scales_.of(e.kind)[level]);
          if (error <= worst[level].error) continue;
          worst[level] = {error, name + " at " + std::to_string(instant.time) + " s"};
        }
    }
    return Flow::go_on;
  }

  PerLevel<Worst> worst;
  int instants = 0;

 private:
  const Model& m_;
  const std::vector<Solution>& motion_;
  const LargestValues scales_;
};

using MechanismAndVariant = std::tuple<LibraryMechanism, Variant>;

class Library : public testing::TestWithParam<MechanismAndVariant> {
 public:
  static std::string name(const testing::TestParamInfo<MechanismAndVariant>& info) {
    return std::string(std::get<0>(info.param).name) + "_" + std::get<1>(info.param).id;
  }
};

TEST_P(Library, AgreesWithTheIndependentSolution) {
  const auto& [model, variant] = GetParam();
  Scene scene = library_scene(model.name);
  // The whole motion in the optimised build; a part of it where every operation is checked.
  if (DESMO_TEST_SECONDS < 30) scene.grid.instants = std::min(scene.grid.instants, 61);
  const Model m = make_model(scene);
  Comparison comparison(m, solutions(scene));
  const auto f = make_formulation(variant, m, Settings{scene.tolerance, 25});
  const Summary s = f->run(scene.grid, {}, comparison);
  EXPECT_TRUE(s.ok()) << describe(s, m);
  EXPECT_EQ(comparison.instants, scene.grid.instants);
  constexpr PerLevel<double> allowed{1e-9, 1e-8, 1e-7};
  for (const Level level : all_levels)
    EXPECT_LE(comparison.worst[level].error, allowed[level])
        << level_names[level] << " of " << comparison.worst[level].where;
}

INSTANTIATE_TEST_SUITE_P(All, Library,
                         testing::Combine(testing::ValuesIn(library().begin(), library().end()),
                                          testing::ValuesIn(tested_variants())),
                         Library::name);

/// What can be known of a mechanism without solving it.
class LibraryMechanisms : public testing::TestWithParam<LibraryMechanism> {
 public:
  static std::string name(const testing::TestParamInfo<LibraryMechanism>& info) {
    return std::string(info.param.name);
  }
};

TEST_P(LibraryMechanisms, EverythingNamedInTheFileHasAnIndependentSolution) {
  const Scene scene = library_scene(GetParam().name);
  std::vector<std::string> named, solved;
  for (const auto& p : scene.mechanism.points) named.push_back(p.name);
  for (const auto& v : scene.mechanism.vectors) named.push_back(v.name);
  for (const auto& c : scene.mechanism.coordinates) named.push_back(c.name);
  for (const auto& [name, q] : exact::library_solutions().at(GetParam().name)(0))
    solved.push_back(name);
  std::ranges::sort(named);
  EXPECT_EQ(named, solved);
  EXPECT_EQ(scene.mechanism.name, GetParam().name);
  EXPECT_GE(scene.grid.instants, 300);
}

TEST_P(LibraryMechanisms, IndependentSolutionsAreSmoothAndTheirOwnDerivatives) {
  const Scene scene = library_scene(GetParam().name);
  const Model m = make_model(scene);
  const auto at = exact::library_solutions().at(GetParam().name);
  const LargestValues scales(m, solutions(scene));
  constexpr double h = 2.5e-4, weight[] = {1.0 / 12, -2.0 / 3, 2.0 / 3, -1.0 / 12};
  for (int i = 0; i < 20; ++i) {
    const double t = scene.grid.time(scene.grid.instants * i / 20);
    const Solution here = at(t), near[] = {at(t - 2 * h), at(t - h), at(t + h), at(t + 2 * h)};
    for (const auto& [name, q] : here)
      for (const auto& [level, next] :
           {std::pair{Level::position, Level::velocity}, {Level::velocity, Level::acceleration}})
        for (int k = 0; k < q.size; ++k) {
          const EntityKind kind = m.entities[m.find(name)].kind;
          double slope = 0;
          for (int j = 0; j < 4; ++j) {
            double change = near[j].at(name).levels[level][k] - q.levels[level][k];
            if (level == Level::position && kind == EntityKind::angle)
              change = std::remainder(change, 2 * std::numbers::pi);
            slope += weight[j] / h * change;
          }
          EXPECT_NEAR(slope, q.levels[next][k], 1e-7 * scales.of(kind)[next])
              << level_names[next] << " of " << name << " at " << t << " s";
        }
  }
}

INSTANTIATE_TEST_SUITE_P(All, LibraryMechanisms,
                         testing::ValuesIn(library().begin(), library().end()),
                         LibraryMechanisms::name);

TEST(LibraryTable, HasTheMechanismsThatHaveSolutions) {
  std::vector<std::string_view> solved;
  for (const auto& [name, at] : exact::library_solutions()) solved.push_back(name);
  EXPECT_EQ(library_names(), solved);
}

}  // namespace
}  // namespace desmo::library_test
}  // namespace desmo
