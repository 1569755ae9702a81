#pragma once

#include <boost/align/aligned_allocator.hpp>
#include <cstddef>
#include <vector>

namespace desmo {

/// Alignment [bytes] of numbers in lanes: the size of the widest register.
inline constexpr std::size_t lane_alignment = 64;

/// Numbers of a batch. Number k of lane l is at k · lanes + l: its lanes stand side by side.
using LaneValues = std::vector<double, boost::alignment::aligned_allocator<double, lane_alignment>>;

/// Copies `size` numbers, which must not overlap their copies. Few numbers stay in registers, and
/// the function call that std::copy_n would make is saved.
template <std::size_t size>
void copy_in_registers(const double* __restrict from, double* __restrict to) {
  for (std::size_t k = 0; k < size; ++k) to[k] = from[k];
}

/// The states of a batch: positions, velocities and accelerations of one part or subsystem in each
/// lane.
struct LaneState {
  LaneValues q, qd, qdd;

  /// Gives all three this size; new numbers are 0.
  void resize(std::size_t size) {
    for (LaneValues* values : {&q, &qd, &qdd}) values->resize(size);
  }
};

}  // namespace desmo
