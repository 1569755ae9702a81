#include "formulations/verification/monitor/recent_instants.h"

#include <algorithm>

namespace desmo {

namespace {

/// Instants kept, and numbers kept at most in all.
constexpr int max_kept = 8, max_numbers = 1 << 21;

}  // namespace

RecentInstants::RecentInstants(int coordinates)
    : nodes_(std::clamp(max_numbers / std::max(1, 3 * coordinates), 1, max_kept)) {
  for (Node& node : nodes_)
    for (std::vector<double>* values : {&node.state.q, &node.state.qd, &node.state.qdd})
      values->resize(coordinates);
}

void RecentInstants::take(const Instant& instant, bool is_assessed,
                          const PerLevel<double>& stated) {
  newest_ = (newest_ + 1) % size();
  count_ = std::min(count_ + 1, size());
  Node& node = nodes_[newest_];
  node.index = instant.index;
  node.time = instant.time;
  node.is_assessed = is_assessed;
  node.stated = stated;
  std::ranges::copy(instant.q, node.state.q.begin());
  std::ranges::copy(instant.qd, node.state.qd.begin());
  std::ranges::copy(instant.qdd, node.state.qdd.begin());
}

void RecentInstants::drop() {
  if (count_ == 0) return;
  newest_ = (newest_ - 1 + size()) % size();
  --count_;
}

void RecentInstants::shift_time(double by) {
  for (Node& node : nodes_) node.time += by;
}

Instant view_of(const RecentInstants::Node& node, const Instant& like) {
  Instant result = like;
  result.time = node.time;
  result.q = node.state.q;
  if (!like.qd.empty()) result.qd = node.state.qd;
  if (!like.qdd.empty()) result.qdd = node.state.qdd;
  return result;
}

}  // namespace desmo
