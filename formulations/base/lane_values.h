#pragma once

#include <cstddef>
#include <new>
#include <vector>

namespace desmo {

/// Allocates memory that the widest registers can be loaded from at once.
template <class T>
struct LaneAllocator {
  using value_type = T;
  static constexpr std::size_t alignment = 64;

  LaneAllocator() = default;
  template <class Other>
  explicit LaneAllocator(const LaneAllocator<Other>&) {}

  T* allocate(std::size_t n) {
    return static_cast<T*>(::operator new(n * sizeof(T), std::align_val_t(alignment)));
  }
  void deallocate(T* p, std::size_t) { ::operator delete(p, std::align_val_t(alignment)); }
  bool operator==(const LaneAllocator&) const = default;
};

/// Numbers of a batch, the lanes of each side by side: number k of lane l at k · lanes + l.
using LaneValues = std::vector<double, LaneAllocator<double>>;

/// Copies a few numbers, which are not worth the call that std::copy_n makes of them.
template <std::size_t size>
void copy_in_registers(const double* __restrict from, double* __restrict to) {
  for (std::size_t k = 0; k < size; ++k) to[k] = from[k];
}

/// A state in each lane.
struct LaneState {
  LaneValues q, qd, qdd;
};

}  // namespace desmo
