// Checked runs, row by row, and their comparison with exact motions.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cases/io/files.h"
#include "formulations/base/reference_instant.h"
#include "formulations/id.h"
#include "formulations/modelling/modelling.h"
#include "formulations/verification/run/checked_run.h"

namespace desmo {

/// A row of a checked run. Levels that were not solved are empty.
struct CheckedRow {
  int index = 0;  ///< of the instant in its grid
  double time = 0;
  bool interpolated = false;
  PerLevel<std::vector<double>> values{}, radius{};
  std::optional<RowFlag> flag{};
};

/// Keeps what an observer receives, or stops after so many rows.
class RowCount final : public Observer {
 public:
  explicit RowCount(int last = -1) : last_(last) {}
  Flow observe(const Instant& i) noexcept override {
    indices.push_back(i.index);
    return i.index == last_ ? Flow::stop : Flow::go_on;
  }
  std::vector<int> indices;

 private:
  int last_;
};

/// A checked run, as its user sees it.
struct CheckedRows {
  CheckedSummary summary{};
  std::vector<CheckedRow> rows{};
};

inline CheckedRows solve_checked(Formulation& formulation, const TimeGrid& grid, Level level,
                                 CheckOptions options) {
  CheckedRows result;
  options.checked = [&](const CheckedInstant& i) {
    const PerLevel<std::span<const double>> values{i.instant.q, i.instant.qd, i.instant.qdd};
    CheckedRow& row = result.rows.emplace_back(CheckedRow{.index = i.instant.index,
                                                          .time = i.instant.time,
                                                          .interpolated = i.instant.interpolated,
                                                          .flag = i.flag});
    for (const Level l : all_levels) {
      row.values[l].assign(values[l].begin(), values[l].end());
      row.radius[l].assign(i.radius[l].begin(), i.radius[l].end());
    }
  };
  RowCount observer;
  result.summary = run_checked(formulation, grid, {level}, observer, options);
  EXPECT_EQ(observer.indices.size(), result.rows.size());
  EXPECT_EQ(result.summary.instants, std::ssize(result.rows));
  return result;
}

inline CheckedRows solve_checked(const Model& m, const TimeGrid& grid, const std::string& id,
                                 Level level = Level::acceleration,
                                 const CheckOptions& options = {}) {
  const Configuration c = parse_id(id);
  return solve_checked(*make_formulation(*c.variant, m, c.settings), grid, level, options);
}

/// Returns |found − exact| of a coordinate, rounded once or twice.
inline double error_of(double found, const ReferenceInstant& exact, Level level, int i) {
  const auto of = [&](const auto& x) -> const std::vector<double>& {
    return level == Level::position ? x.q : level == Level::velocity ? x.qd : x.qdd;
  };
  const std::vector<double>& rest = of(exact.remainder);
  return std::abs(found - of(exact)[i] - (rest.empty() ? 0 : rest[i]));
}

/// Expects the numbers of rows that are on the branch to be within their radii. Times that rows and
/// reference do not share are skipped. Returns how many rows were compared.
inline int expect_within_radii(const Model& m, std::span<const CheckedRow> rows,
                               std::span<const ReferenceInstant> reference) {
  int compared = 0;
  std::string first;  // number that is not
  auto row = rows.begin();
  for (const ReferenceInstant& exact : reference) {
    while (row != rows.end() && row->time < exact.time) ++row;
    if (row == rows.end() || row->time != exact.time) continue;
    using enum RowFlag::Kind;
    if (row->radius.position.empty()) continue;
    if (row->flag && (row->flag->kind == branch || row->flag->kind == on_point)) continue;
    ++compared;
    for (const Level level : all_levels)
      for (std::size_t i = 0; i < row->values[level].size(); ++i) {
        const double error = error_of(row->values[level][i], exact, level, static_cast<int>(i));
        const double radius = row->radius[level][i];
        if (first.empty() && !(error <= radius))
          first = "coordinate " + std::to_string(i) + ", level " +
                  std::to_string(static_cast<int>(level)) + ", t = " + std::to_string(exact.time) +
                  ": error " + std::to_string(error / radius) + " radii";
      }
  }
  EXPECT_EQ(first, "") << m.name;
  return compared;
}

/// Returns the times of at most `count` rows, evenly spread.
inline std::vector<double> times_of(std::span<const CheckedRow> rows, int count) {
  const std::size_t last = rows.size() - 1, n = std::min<std::size_t>(rows.size(), count);
  std::vector<double> times;
  for (std::size_t i = 0; i < n; ++i) times.push_back(rows[i * last / (n - 1)].time);
  return times;
}

/// Reads a scene of this folder.
inline Scene scene_file(const std::string& name) {
  return read_scene(DESMO_SOURCE_DIR "/tests/checked/scenes/" + name + ".json");
}

}  // namespace desmo
