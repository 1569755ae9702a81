#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/base/per_level.h"

namespace desmo {

/// Measures of a step of length h: each the largest over all coordinates, times a weight.
struct StepMeasures {
  double rate = 0;  ///< |q̇| at the end
  double mismatch = 0;  ///< error of the trapezoid rule: |v₁ − v₀ − h/2 (a₀ + a₁)|, v the highest
                        ///< level but one, a the highest
  bool is_bound = false;  ///< the mismatch by weights that it is judged by is at most this one
};

/// Copies of the last instants, and what was stated of them.
class RecentInstants {
 public:
  /// Copy of an instant.
  struct Node {
    double time = 0;
    State state;
    bool is_assessed = false;
    PerLevel<double> stated;  ///< bounds
  };

  explicit RecentInstants(int coordinates);

  /// Measures the step from the last instant to one with velocities. Copies it on the way, which
  /// take() then need not do. weights: (coordinates).
  StepMeasures measure(const Instant& to, const double* weights);

  void take(const Instant& instant, bool is_assessed, const PerLevel<double>& stated);
  void forget() {
    count_ = 0;
    forget_copy();
  }
  /// Forgets the copy of an instant that measure() made and take() did not get.
  void forget_copy() { copied_ = nullptr; }
  /// Drops the last instant, if there is one.
  void drop();
  void shift_time(double by);

  int count() const { return count_; }
  /// Returns an instant; 0 is the last, count() − 1 the earliest.
  Node& operator[](int back) { return nodes_[(newest_ + size() - back) % size()]; }
  const Node& operator[](int back) const { return nodes_[(newest_ + size() - back) % size()]; }

 private:
  int size() const { return static_cast<int>(nodes_.size()); }
  Node& next() { return nodes_[(newest_ + 1) % size()]; }

  std::vector<Node> nodes_;  // one more than are kept
  int newest_ = 0, count_ = 0;
  const double* copied_ = nullptr;  // q of the instant that next() is a copy of
};

/// Returns a view of a node, as far as `like` is solved.
Instant view_of(const RecentInstants::Node& node, const Instant& like);

}  // namespace desmo
