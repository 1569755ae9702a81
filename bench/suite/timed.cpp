#include "bench/suite/timed.h"

#include <malloc.h>

#include <exception>
#include <random>
#include <thread>

#include "bench/suite/cpu_clock.h"

namespace desmo::suite {

double Timed::time_afresh() {
  static std::minstd_rand random(1);  // the same draws in every run
  constexpr int places = 256;         // of 16 bytes each: a page
  const std::vector<char>::size_type shift = 16 * (random() % places);
  double seconds = 0;
  std::exception_ptr error;
  malloc_trim(0);  // other pages than those of the last one
  std::thread([&] {
    try {
      const std::vector<char> shifted_by(shift);
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
