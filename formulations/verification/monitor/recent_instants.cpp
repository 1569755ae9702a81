#include "formulations/verification/monitor/recent_instants.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <experimental/simd>
#include <utility>

namespace desmo {

namespace {

/// Instants kept, the last and the one to go back to, and numbers kept at most in all.
constexpr int max_kept = 2, max_numbers = 1 << 21;

/// The levels of a step: x and its rate r, at both ends.
struct Streams {
  const double *x0, *x1, *r0, *r1;
  double *x, *r;  // copies of those at the end
  double half_step;
};

/// The largest measures of coordinates in each place of a register. Velocities are x or r.
template <class Register, bool are_velocities>
struct MaxMeasures {
  Register rate = 0, mismatch = 0;

  void take(const Streams& s, const double* weights, int i) {
    namespace simd = std::experimental;
    const auto at = [i](const double* from) { return Register(from + i, simd::element_aligned); };
    const Register x0 = at(s.x0), x1 = at(s.x1), r0 = at(s.r0), r1 = at(s.r1);
    const Register weight = at(weights);
    rate = max(rate, abs(are_velocities ? x1 : r1) * weight);
    mismatch = max(mismatch, abs(x1 - x0 - s.half_step * (r0 + r1)) * weight);
    x1.copy_to(s.x + i, simd::element_aligned);
    r1.copy_to(s.r + i, simd::element_aligned);
  }
};

template <bool are_velocities>
StepMeasures measure_all(const Streams& s, const double* weights, int n) {
  using Full = std::experimental::native_simd<double>;
  using Single = std::experimental::simd<double, std::experimental::simd_abi::scalar>;
  constexpr int width = static_cast<int>(Full::size());
  MaxMeasures<Full, are_velocities> most;
  int i = 0;
  for (; i + width <= n; i += width) most.take(s, weights, i);
  MaxMeasures<Single, are_velocities> all{hmax(most.rate), hmax(most.mismatch)};
  for (; i < n; ++i) all.take(s, weights, i);
  return {all.rate[0], all.mismatch[0]};
}

}  // namespace

RecentInstants::RecentInstants(int coordinates)
    : nodes_(1 + std::clamp(max_numbers / std::max(1, 3 * coordinates), 1, max_kept)) {
  for (Node& node : nodes_)
    for (std::vector<double>* values : {&node.state.q, &node.state.qd, &node.state.qdd})
      values->resize(coordinates);
}

StepMeasures RecentInstants::measure(const Instant& to, const double* weights) {
  const Node& from = (*this)[0];
  Node& copy = next();
  const auto& [q, qd, qdd] = from.state;
  auto& [to_q, to_qd, to_qdd] = copy.state;
  const double half_step = (to.time - from.time) / 2;
  const int n = static_cast<int>(to.q.size());
  copied_ = to.q.data();
  if (to.qdd.empty())
    return measure_all<false>(
        {q.data(), to.q.data(), qd.data(), to.qd.data(), to_q.data(), to_qd.data(), half_step},
        weights, n);
  std::memcpy(to_q.data(), to.q.data(), to.q.size_bytes());
  return measure_all<true>(
      {qd.data(), to.qd.data(), qdd.data(), to.qdd.data(), to_qd.data(), to_qdd.data(), half_step},
      weights, n);
}

void RecentInstants::take(const Instant& instant, bool is_assessed,
                          const PerLevel<double>& stated) {
  Node& node = next();
  newest_ = (newest_ + 1) % size();
  count_ = std::min(count_ + 1, size() - 1);
  node.time = instant.time;
  node.is_assessed = is_assessed;
  node.stated = stated;
  if (std::exchange(copied_, nullptr) == instant.q.data()) return;
  std::ranges::copy(instant.q, node.state.q.begin());
  std::ranges::copy(instant.qd, node.state.qd.begin());
  std::ranges::copy(instant.qdd, node.state.qdd.begin());
}

void RecentInstants::drop() {
  forget_copy();
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
