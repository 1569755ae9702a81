#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/per_level.h"
#include "formulations/base/reference_instant.h"
#include "formulations/model/model.h"
#include "tests/formulated.h"

namespace desmo {

/// The largest differences of a model from known instants: its own, or those of another model,
/// whose entities have the same names.
class NamedDifference final : public Observer {
 public:
  NamedDifference(const Model& m, const Model& known,
                  const std::vector<ReferenceInstant>& reference)
      : reference_(reference) {
    for (const Entity& e : known.entities) {
      if (e.fixed) continue;
      const Entity& same = m.entities[m.find(e.name)];
      EXPECT_EQ(same.size, e.size) << e.name;
      EXPECT_FALSE(same.internal) << e.name;
      for (int i = 0; i < e.size; ++i) {
        from_.push_back(e.first + i);
        to_.push_back(same.fixed ? -1 : same.first + i);
        names_.push_back(e.name);
      }
    }
  }

  Flow observe(const Instant& instant) noexcept override {
    if (seen_ == reference_.size() || std::abs(instant.time - reference_[seen_].time) > 1e-9)
      return Flow::go_on;
    const ReferenceInstant& r = reference_[seen_++];
    widen(largest_.position, instant.q, r.q);
    widen(largest_.velocity, instant.qd, r.qd);
    widen(largest_.acceleration, instant.qdd, r.qdd);
    return Flow::go_on;
  }

  /// Expects that all known instants were compared and agree to 1e-9, 1e-8 and 1e-7 by level.
  void expect_agreement(const std::string& where) const {
    constexpr PerLevel<double> tolerance{1e-9, 1e-8, 1e-7};
    EXPECT_EQ(seen_, reference_.size()) << where;
    for (const Level level : all_levels)
      EXPECT_LE(largest_[level], tolerance[level]) << where << " " << worst_;
  }

 private:
  void widen(double& largest, std::span<const double> a, const std::vector<double>& b) {
    for (std::size_t i = 0; i < from_.size(); ++i) {
      const double off = to_[i] < 0 ? 0 : larger_error(0, std::abs(a[to_[i]] - b[from_[i]]));
      if (off <= largest) continue;
      largest = off;
      worst_ = names_[i];
    }
  }

  const std::vector<ReferenceInstant>& reference_;
  PerLevel<double> largest_;
  std::size_t seen_ = 0;  // instants compared so far
  std::string worst_;     // name of the entity of the difference found last
  std::vector<int> from_, to_;
  std::vector<std::string> names_;
};

}  // namespace desmo
