// The algebra `mixed`: the rule of choice with given times, and what formulations make of it.
// Nothing here depends on what is fast on the machine.

#include "formulations/algebra/mixed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
#include <typeinfo>
#include <utility>

#include "formulations/algebra/step_seconds.h"
#include "formulations/id.h"
#include "formulations/magnitudes.h"
#include "formulations/part_solvers.h"
#include "formulations/part_type.h"
#include "formulations/variants.h"
#include "tests/mechanisms.h"

namespace desmo::mixed_test {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

PartContext context(const Mechanism& m, const PartDefinition& part, const Settings& settings = {}) {
  return {m, part, Magnitudes(m).weights(part), std::nullopt, settings};
}

std::size_t position_of(std::string_view name) {
  return std::ranges::find(backends(), name, [](const Backend* b) { return b->name; }) -
         backends().begin();
}

TEST(Fastest, IsTheFirstOfThoseThatAreAsFast) {
  EXPECT_EQ(fastest(std::vector{1.0}), 0u);
  EXPECT_EQ(fastest(std::vector{3.0, 1.0, 2.0}), 1u);
  EXPECT_EQ(fastest(std::vector{1.0, 0.96, 0.94, 0.92}), 2u) << "more than 5 % is needed";
  EXPECT_EQ(fastest(std::vector{1.0, 0.96, 0.955}), 0u);
  EXPECT_EQ(fastest(std::vector{never, 2.0, never}), 1u);
  EXPECT_EQ(fastest(std::vector{never, never}), 0u);
}

/// Times as given, and how often they were asked for.
class Given {
 public:
  BackendChoice choice() {
    return {backends(), [this](const PartContext&, std::span<const Backend* const> candidates) {
              ++measured;
              last.assign(candidates.begin(), candidates.end());
              std::vector<double> seconds(candidates.size(), 2);
              const auto fast = std::ranges::find(last, fast_one, &Backend::name);
              if (fast != last.end()) seconds[fast - last.begin()] = 1;
              return seconds;
            }};
  }
  std::string_view fast_one;
  int measured = 0;
  std::vector<const Backend*> last;
};

TEST(BackendChoice, TakesTheFastestOfThoseThatLoseNoDigits) {
  const Mechanism m = truck_mechanism(1);
  const PartDefinition part = make_partition(m, Partition::group).back();
  for (const Backend* b : backends()) {
    Given given;
    given.fast_one = b->name;
    const std::string_view taken = given.choice().of(context(m, part)).name;
    EXPECT_EQ(taken, b->squares_condition ? "klu" : b->name);
    EXPECT_EQ(std::ranges::count(given.last, b), !b->squares_condition);
  }
}

TEST(BackendChoice, TakesASparseOneOfThoseThatAreAsFast) {
  const Mechanism m = truck_mechanism(1);
  const PartDefinition part = make_partition(m, Partition::group).back();
  Given given;
  EXPECT_EQ(given.choice().of(context(m, part)).name, "klu");
}

TEST(BackendChoice, MeasuresEachTypeOnce) {
  const Mechanism m = truck_mechanism(2);
  std::set<std::string> types;
  Given given;
  BackendChoice choice = given.choice();
  for (const PartDefinition& part : make_partition(m, Partition::group)) {
    const bool is_new = types.insert(describe_type(m, part).fingerprint).second;
    const int before = given.measured;
    given.fast_one = is_new ? "klu" : "eigen";  // what an equal part is not to be asked again
    EXPECT_EQ(choice.of(context(m, part)).name, "klu");
    EXPECT_EQ(given.measured, before + is_new);
  }
  EXPECT_GT(make_partition(m, Partition::group).size(), types.size());
  EXPECT_GT(types.size(), 1u);
}

TEST(BackendChoice, MeasuresAnewWhereAStepIsOtherWork) {
  const Mechanism m = truck_mechanism(1);
  const PartDefinition part = make_partition(m, Partition::group).back();
  Given given;
  BackendChoice choice = given.choice();
  for (const Settings& settings : {Settings{}, Settings{.jacobian = JacobianUpdate::step},
                                   Settings{.jacobian = JacobianUpdate::chord},
                                   Settings{.factorisation = Factorisation::per_level}}) {
    const int before = given.measured;
    choice.of(context(m, part, settings));
    EXPECT_EQ(given.measured, before + 1);
  }
  choice.of(context(m, part, {.tolerance = 1e-6, .guess = Guess::hermite5}));
  EXPECT_EQ(given.measured, 4) << "neither changes what an iteration costs";
  PartContext symbolic = context(m, part);
  symbolic.kernels.emplace();
  choice.of(symbolic);
  EXPECT_EQ(given.measured, 5);
}

TEST(BackendChoice, TriesDenseMatricesWhereTheyAreSmall) {
  const auto candidates = [](int axles) {
    const Mechanism m = truck_mechanism(axles);
    Given given;
    given.choice().of(context(m, make_partition(m, Partition::global).back()));
    return std::ranges::count(given.last, true, &Backend::dense);
  };
  EXPECT_EQ(candidates(1), 2);
  EXPECT_EQ(candidates(5), 0);
}

TEST(StepSeconds, AreThoseOfEveryLibrary) {
  const Mechanism m = truck_mechanism(1);
  Profile profile;
  const PartDefinition part = make_partition(m, Partition::group)[1];
  PartContext measured = context(m, part);
  measured.profile = &profile;
  const std::vector<double> seconds = step_seconds(measured, backends());
  ASSERT_EQ(seconds.size(), backends().size());
  for (std::size_t i = 0; i < seconds.size(); ++i) {
    EXPECT_GT(seconds[i], 0) << backends()[i]->name;
    EXPECT_TRUE(std::isfinite(seconds[i])) << backends()[i]->name;
  }
  EXPECT_EQ(profile.calls, Profile{}.calls) << "they are no phases of the formulation";
}

/// A dyad folded onto itself: Φ_φ is exactly singular, which who pivots finds.
TEST(StepSeconds, AreInfiniteWhereThePositionIsSingular) {
  Mechanism m = four_bar_mechanism(1);
  m.fixed_values[m.entities[m.find("dyad1/D")].first] = 2;
  const auto set = [&](const char* name, std::initializer_list<double> values) {
    std::ranges::copy(values, m.estimate.begin() + m.entities[m.find(name)].first);
  };
  set("crank/B", {2, 0});
  set("dyad1/C", {8, 0});
  set("dyad1/psi", {0});
  const PartDefinition dyad = make_partition(m, Partition::group)[1];
  const std::vector<double> seconds = step_seconds(context(m, dyad), backends());
  for (const char* name : {"lapack", "eigen", "klu"})
    EXPECT_EQ(seconds[position_of(name)], never) << name;
}

using Choices = std::map<std::string, std::set<std::string_view>>;

void add_choices(const Formulation& f, Choices& choices) {
  for (const Formulation::DefinedPart& part : f.parts())
    choices[describe_type(f.mechanism(), part.definition).fingerprint].insert(part.algebra);
}

TEST(Mixed, SolvesEqualPartsByEqualSolversInEveryFormulation) {
  for (const char* id : {"group_automatic_mixed", "block_symbolic_mixed"}) {
    Choices choices;
    for (const int axles : {2, 1, 3})
      add_choices(*make_formulation(find_variant(id), truck_mechanism(axles)), choices);
    Choices elsewhere = choices;
    std::thread([&] {
      add_choices(*make_formulation(find_variant(id), truck_mechanism(2)), elsewhere);
    }).join();
    EXPECT_EQ(elsewhere, choices);
    for (const auto& [type, solvers] : choices) EXPECT_EQ(solvers.size(), 1u) << type;
  }
}

/// Not a part around a part: the same class as in the formulation that names the library.
TEST(Mixed, HasThePartsOfTheLibrariesThemselves) {
  const Mechanism m = truck_mechanism(1);
  for (const std::string start : {"group_automatic_", "group_symbolic_", "global_automatic_"}) {
    const auto mixed = make_formulation(find_variant(start + "mixed"), m);
    for (std::size_t i = 0; i < mixed->parts().size(); ++i) {
      const Formulation::DefinedPart& part = mixed->parts()[i];
      const auto named = make_formulation(find_variant(start + std::string(part.algebra)), m);
      const Part &a = *part.solver, &b = *named->parts()[i].solver;
      EXPECT_EQ(typeid(a), typeid(b)) << start << part.algebra;
    }
  }
}

TEST(Mixed, RefusesScalarsThatSparseLibrariesDoNotHave) {
  for (const char* suffix : {"/scalar:mixed", "/scalar:float/iterations:2"})
    EXPECT_THROW(parse_id(std::string("group_automatic_mixed") + suffix), std::invalid_argument);
  EXPECT_TRUE(chooses_solvers(find_variant("group_automatic_mixed")));
  EXPECT_FALSE(chooses_solvers(find_variant("group_automatic_klu")));
  EXPECT_FALSE(chooses_solvers(find_variant("group_symbolic_inlined")));
}

TEST(PartSolvers, AreCountedByLibraryWithoutConstantParts) {
  const Mechanism m = truck_mechanism(2);
  const auto f = make_formulation(find_variant("group_automatic_klu"), m);
  const std::vector<PartSolver> one = part_solvers(*f);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].algebra, "klu");
  EXPECT_EQ(one[0].parts, 10);
  EXPECT_EQ(one[0].least_unknowns, 16);
  EXPECT_EQ(one[0].most_unknowns, 39);

  const auto mixed = make_formulation(find_variant("block_automatic_mixed"), m);
  const std::vector<PartSolver> several = part_solvers(*mixed);
  int parts = 0;
  for (const PartSolver& s : several) parts += s.parts;
  EXPECT_EQ(parts, std::ranges::count(mixed->parts(), false,
                                      [](const auto& part) { return part.definition.constant; }));
  EXPECT_EQ(several.front().most_unknowns, 16);
}

}  // namespace
}  // namespace desmo::mixed_test
