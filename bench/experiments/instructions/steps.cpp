// desmo_steps CASE COORDINATES ID STEPS [ITERATIONS [PERCENT]]: assembles and takes STEPS steps of
// 10 ms, nothing else, for instruction counts and profilers. ITERATIONS: exact number of Newton
// iterations of every step; 0: as many as it needs. PERCENT: share of the steps that is taken
// again, a slowdown on purpose: tests see whether it is found. Function desmo_counted_steps takes
// all steps after uncounted_steps. It takes the whole motion, assembly included, with an id that
// asks for segments, threads or a stride, or that ends in /check:….

#include <malloc.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <utility>

#include "bench/kit/candidate_name.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/exit_codes.h"
#include "bench/regression/rounds.h"
#include "bench/regression/stepped_formulation.h"

namespace {

using desmo::regression::SteppedFormulation;

/// Allocates for good all free blocks that earlier work has left in the heap. Libraries such as
/// UMFPACK allocate in every step, and the instructions that this takes depend on free blocks.
void fill_holes() {
  static void* taken = nullptr;  // last block; it begins with a pointer to the one before
  const auto take = [](std::size_t size) {
    void* const block = std::malloc(size);
    *static_cast<void**>(block) = taken;
    taken = block;
  };
  const auto holes = [] {
    const struct mallinfo2 heap = mallinfo2();
    return heap.fordblks - heap.keepcost;
  };
  // Without fast bins, only glibc's thread cache hides freed blocks: seven of each size.
  mallopt(M_MXFAST, 0);
  constexpr std::size_t apart = 16, max_at_hand = 1040;  // [bytes]: spacing, limit of cached sizes
  for (std::size_t size = apart; size <= max_at_hand; size += apart)
    for (int i = 0; i < 7; ++i) take(size);
  for (std::size_t size = 1 << 16, left = holes(); size >= apart; size -= apart)
    for (;;) {
      take(size);
      const std::size_t now = holes();
      if (now >= left) {  // the block is from the end of the heap: no hole has room for this size
        std::free(std::exchange(taken, *static_cast<void**>(taken)));
        break;
      }
      left = now;
    }
}

}  // namespace

extern "C" [[gnu::noinline]] desmo::Summary desmo_counted_steps(SteppedFormulation& stepped,
                                                                desmo::CheckMode check, int first,
                                                                int last, int repeated) {
  if (check != desmo::CheckMode::none)
    return desmo::bench::run_under_check(stepped.formulation(), stepped.grid, {},
                                         stepped.delivery(), check);
  if (stepped.runs_at_once()) return stepped.run();
  const desmo::Summary s = stepped.walk(first, last);
  return s.ok() && repeated > 0 ? stepped.walk(last - 1, last - repeated) : s;
}

int main(int argc, char** argv) {
  using namespace desmo;
  if (argc < 5 || argc > 7) {
    std::cerr << "usage: desmo_steps CASE COORDINATES ID STEPS [ITERATIONS [PERCENT]]\n";
    return desmo::bench::usage_error;
  }
  try {
    const auto whole = [](const char* text) { return bench::whole_number(text, 0, 1'000'000'000); };
    const int steps = whole(argv[4]), repeated = argc > 6 ? whole(argv[6]) : 0;
    Settings settings;
    if (argc > 5) settings.fixed_iterations = whole(argv[5]);
    const int first = std::min(regression::CountingSettings::uncounted_steps, steps);
    const CheckMode check = bench::check_of(argv[3]);
    const std::string id(bench::formulation_of(argv[3]));
    const bench::Problem problem = regression::problem_of({argv[1], whole(argv[2]), id}, steps + 1);
    SteppedFormulation stepped(problem, id, settings);
    fill_holes();
    Summary s;
    if (check == CheckMode::none && !stepped.runs_at_once()) s = stepped.walk(0, first);
    if (s.ok() && first < steps)
      s = desmo_counted_steps(stepped, check, first + 1, steps,
                              regression::extra_steps(steps - first, repeated));
    if (s.ok() && s.residual > stepped.settings().tolerance)  // possible with fixed iterations only
      s.status = Status::not_converged;
    if (s.ok()) return 0;
    std::cerr << "desmo_steps: " << describe(s, problem.plan.model) << '\n';
    return 1;
  } catch (const std::exception& e) {
    std::cerr << "desmo_steps: " << e.what() << '\n';
    // Wrong usage tells bench/check --history that there is no such candidate.
    const bool is_usage = dynamic_cast<const std::invalid_argument*>(&e);
    return is_usage ? bench::usage_error : bench::internal_error;
  }
}
