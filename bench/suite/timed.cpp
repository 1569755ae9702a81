#include "bench/suite/timed.h"

#include <benchmark/benchmark.h>

#include <cstddef>
#include <exception>
#include <memory>
#include <random>
#include <thread>

#include "bench/suite/cpu_clock.h"

namespace desmo::suite {

double Timed::time_afresh() {
  static std::minstd_rand random(1);          // the same draws in every run
  constexpr std::size_t places = 256 * 1024;  // of 16 bytes each: a thousand pages
  const std::size_t shift = 16 * (random() % places);
  double seconds = 0;
  std::exception_ptr error;
  std::thread([&] {
    try {
      const auto shifted_by = std::make_unique_for_overwrite<char[]>(shift);
      benchmark::DoNotOptimize(shifted_by.get());  // or it would not be allocated
      make();
      const double before = cpu_now();
      analyse();
      seconds = cpu_now() - before;
      discard();
    } catch (...) {
      error = std::current_exception();
    }
  }).join();
  if (error) std::rethrow_exception(error);
  return seconds;
}

}  // namespace desmo::suite
