#pragma once

#include <span>
#include <vector>

#include "formulations/base/observer.h"
#include "formulations/base/part.h"
#include "formulations/base/per_level.h"

namespace desmo {

/// Copies of the last few instants, and what was stated of them. What follows may show that they
/// were worse.
class RecentInstants {
 public:
  /// Copy of an instant.
  struct Node {
    int index = 0;
    double time = 0;
    State state;
    bool is_assessed = false;
    PerLevel<double> stated;  ///< bounds
  };

  explicit RecentInstants(int coordinates);

  void take(const Instant& instant, bool is_assessed, const PerLevel<double>& stated);
  void forget() { count_ = 0; }
  /// Drops the last instant, if there is one.
  void drop();
  void shift_time(double by);

  int count() const { return count_; }
  /// Returns an instant; 0 is the last, count() − 1 the earliest.
  Node& operator[](int back) { return nodes_[(newest_ + size() - back) % size()]; }
  const Node& operator[](int back) const { return nodes_[(newest_ + size() - back) % size()]; }

 private:
  int size() const { return static_cast<int>(nodes_.size()); }

  std::vector<Node> nodes_;
  int newest_ = 0, count_ = 0;
};

/// Returns a view of a node, as far as `like` is solved.
Instant view_of(const RecentInstants::Node& node, const Instant& like);

}  // namespace desmo
