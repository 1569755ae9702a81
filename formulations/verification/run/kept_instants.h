#pragma once

#include <algorithm>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/per_level.h"

namespace desmo {

/// Copies of instants that wait for a later one. Memory is taken once.
class KeptInstants {
 public:
  /// count: largest number; coordinates: of each instant.
  KeptInstants(int count, int coordinates) : values_(count), instants_(count) {
    for (auto& levels : values_)
      for (const Level level : all_levels) levels[level].resize(coordinates);
  }

  bool empty() const { return size_ == 0; }
  int size() const { return size_; }
  const Instant& operator[](int i) const { return instants_[i]; }
  void clear() { size_ = 0; }

  void add(const Instant& instant) {
    PerLevel<std::vector<double>>& values = values_[size_];
    Instant& kept = instants_[size_++];
    kept = instant;
    const auto keep = [](std::span<const double> from, std::vector<double>& to) {
      std::ranges::copy(from, to.begin());
      return from.empty() ? std::span<const double>() : std::span<const double>(to);
    };
    kept.q = keep(instant.q, values.position);
    kept.qd = keep(instant.qd, values.velocity);
    kept.qdd = keep(instant.qdd, values.acceleration);
  }

 private:
  std::vector<PerLevel<std::vector<double>>> values_;
  std::vector<Instant> instants_;
  int size_ = 0;
};

}  // namespace desmo
