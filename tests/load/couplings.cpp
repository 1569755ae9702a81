// Couplings of all kinds, and bodies by tables of their points, against closed forms: in every
// partition, with automatic and generated equations, and proven.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "cases/mechanism/formatted.h"
#include "formulations/verification/run/checked_run.h"
#include "tests/everything.h"
#include "tests/load/closed_forms.h"
#include "tests/load/loading.h"

namespace desmo::load::couplings_test {
namespace {

using namespace closed_forms;

struct Coupled {
  const char* scene;
  Values (*at)(double t);
  bool exact = false;  ///< the closed form has the numbers of the file to their last digit
};

void PrintTo(const Coupled& coupled, std::ostream* out) { *out << coupled.scene; }

constexpr Coupled all[] = {
    {"cam_dwell", cam_dwell, true},
    {"indexing", indexing, true},
    {"curved_rail", curved_rail},
    {"gear_train", gear_train},
    {"planetary_gear", planetary_gear},
    {"rack_steering", rack_steering},
    {"belt_arm", belt_arm},
    {"screw_jack", screw_jack},
    {"mimic_gripper", mimic_gripper},
    {"wound_drum", wound_drum},
    {"excavator", excavator},
    {"guides", guides},
};

/// Every coupling counts whole turns, so angles are compared as they are.
class Couplings : public Loading, public testing::WithParamInterface<Coupled> {
 protected:
  void SetUp() override {
    take(GetParam().scene);
    for (int i = 0; i < scene_.grid.instants; ++i)
      exact_.push_back(GetParam().at(scene_.grid.time(i)));
    for (const Values& values : exact_)
      for (const auto& [name, x] : values) {
        auto& largest = scale_.emplace(name, PerLevel<double>{1, 1, 1}).first->second;
        for (const Level level : all_levels)
          largest[level] = std::max(largest[level], static_cast<double>(std::abs(x.at(level))));
      }
  }

  /// radius: of what is found, where it is to hold.
  void compare(int i, const PerLevel<std::span<const double>>& found, const std::string& what,
               const PerLevel<std::span<const double>>* radius = nullptr) {
    constexpr Real closed_form = 2e-17;  // its own error
    for (const auto& [name, x] : exact_[i])
      for (const Level level : all_levels) {
        const Real off = std::abs(model_.value(name, found[level], level) - x.at(level));
        const double scale = scale_[name][level];
        const auto where = [&, &name = name] {
          return formatted("%s: %s, level %d, row %d", what.c_str(), name.c_str(),
                           static_cast<int>(level), i);
        };
        EXPECT_LE(off, 1e-12 * scale) << where();
        if (radius)
          EXPECT_LE(off, model_.value(name, (*radius)[level], level) + closed_form * scale)
              << where();
      }
  }

  /// Compares a run that is not checked.
  void compare_run(const std::string& id, KernelTable& table) {
    const Everything found = everything_of(*made(id, table, exact), scene_.grid);
    const std::size_t n = static_cast<std::size_t>(model_.coordinates());
    for (int i = 0; i < scene_.grid.instants; ++i) {
      const std::span<const double> all = found.all[i];
      ASSERT_EQ(all.size(), 3 * n) << id;
      compare(i, {all.first(n), all.subspan(n, n), all.last(n)}, id);
    }
  }

  static constexpr Settings exact{.tolerance = 1e-14};
  std::vector<Values> exact_;
  std::map<std::string, PerLevel<double>> scale_;  // largest of a motion, at least 1
};

TEST_P(Couplings, KeepTheClosedForm) {
  KernelTable table;
  for (const std::string id :
       {"global_automatic_klu", "group_automatic_lapack", "block_automatic_eigen",
        "global_symbolic_klu", "group_symbolic_lapack", "group_symbolic_inlined",
        "group_symbolic_explicit", "block_symbolic_inlined", "block_symbolic_explicit"}) {
    const auto f = made(id, table, exact);
    CheckOptions options;
    int rows = 0, flagged = 0;
    options.checked = [&](const CheckedInstant& i) {
      ++rows;
      flagged += i.flag.has_value();
      compare(i.instant.index, {i.instant.q, i.instant.qd, i.instant.qdd}, id + ", checked",
              GetParam().exact ? &i.radius : nullptr);
    };
    Everything found(scene_.grid.instants);
    EXPECT_TRUE(run_checked(*f, scene_.grid, {}, found, options).ok()) << id;
    EXPECT_EQ(rows, scene_.grid.instants) << id;
    EXPECT_EQ(flagged, 0) << id;
    compare_run(id, table);
    if (HasFailure()) return;
  }
}

class CouplingsInSegments : public Couplings {};

TEST_P(CouplingsInSegments, CountWholeTurns) {
  KernelTable table;
  compare_run("group_symbolic_explicit/segments:4", table);
  compare_run("group_automatic_lapack/threads:2", table);
}

TEST_P(Couplings, AreReadAgainAsTheyAreWritten) {
  const Mechanism again = parse_mechanism(write_mechanism(scene_.mechanism), "again.json");
  for (std::size_t b = 0; b < again.bodies.size(); ++b)
    if (const auto& own = scene_.mechanism.bodies[b].own)
      EXPECT_EQ(again.bodies[b].own->origin, own->origin);
  ASSERT_EQ(again.couplings.size(), scene_.mechanism.couplings.size());
  for (std::size_t k = 0; k < again.couplings.size(); ++k) {
    const Mechanism::Coupling &a = again.couplings[k], &b = scene_.mechanism.couplings[k];
    EXPECT_EQ(a.name, b.name);
    ASSERT_EQ(a.terms.size(), b.terms.size());
    for (std::size_t i = 0; i < a.terms.size(); ++i) {
      EXPECT_EQ(a.terms[i].coordinate, b.terms[i].coordinate);
      EXPECT_EQ(a.terms[i].factor.value, b.table ? 1 : b.terms[i].factor.value);
    }
    ASSERT_EQ(a.table.has_value(), b.table.has_value());
    if (!b.table) continue;
    const auto compare = [](const std::vector<double>& in_si, const std::vector<double>& numbers,
                            const Derived& factor) {
      ASSERT_EQ(in_si.size(), numbers.size());
      for (std::size_t i = 0; i < numbers.size(); ++i)
        EXPECT_EQ(in_si[i], (Derived(numbers[i]) / factor).value);
    };
    compare(a.table->arguments, b.table->arguments, b.terms[1].factor);
    compare(a.table->values, b.table->values, b.terms[0].factor);
    EXPECT_EQ(a.table->ends, b.table->ends);
    ASSERT_EQ(a.table->from.has_value(), b.table->from.has_value());
    if (b.table->from) EXPECT_EQ(a.table->from->value, b.table->from->value);
  }
}

std::string scene_name(const testing::TestParamInfo<Coupled>& info) { return info.param.scene; }

INSTANTIATE_TEST_SUITE_P(Table, Couplings, testing::ValuesIn(all), scene_name);
INSTANTIATE_TEST_SUITE_P(Table, CouplingsInSegments,
                         testing::Values(Coupled{"belt_arm", belt_arm},
                                         Coupled{"wound_drum", wound_drum},
                                         Coupled{"indexing", indexing}),
                         scene_name);

}  // namespace
}  // namespace desmo::load::couplings_test
