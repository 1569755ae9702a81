#include "bench/kit/memory.h"

#include <cstddef>
#include <future>
#include <memory>
#include <random>

namespace desmo::bench {

void run_on_fresh_heap(const std::function<void()>& work) {
  static std::minstd_rand random(1);          // the same draws in every run
  constexpr std::size_t places = 256 * 1024;  // places of data, 16 bytes apart: a thousand pages
  const std::size_t shift = 16 * (random() % places);
  std::async(std::launch::async, [&] {
    const auto shifted_by = std::make_unique_for_overwrite<char[]>(shift);
    asm volatile("" : : "r"(shifted_by.get()) : "memory");  // else the compiler leaves it out
    work();
  }).get();
}

void keep_freed_memory() {
  mallopt(M_MMAP_THRESHOLD, 1 << 28);
  mallopt(M_TRIM_THRESHOLD, 1 << 30);
}

}  // namespace desmo::bench
