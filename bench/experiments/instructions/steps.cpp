// desmo_steps CASE COORDINATES ID STEPS [ITERATIONS [PERCENT]]: assembles and takes so many steps
// of 10 ms, nothing else, for instruction counts and profilers. With ITERATIONS every step takes
// exactly so many Newton iterations; 0: as many as it needs. PERCENT repeats that share of the
// steps: a slowdown on purpose, for tests of what is to find one. The steps after uncounted_steps
// are all in desmo_counted_steps. With an id that solves more than one instant at once, or that
// ends in /check:…, the whole motion is in it, assembly included.

#include <algorithm>
#include <exception>
#include <iostream>
#include <string>

#include "bench/experiments/instructions/step_counts.h"
#include "bench/kit/checked_run.h"
#include "bench/kit/options.h"
#include "bench/regression/rounds.h"
#include "bench/regression/stepped_formulation.h"

namespace {

using desmo::regression::SteppedFormulation;

static_assert(desmo::regression::CountingSettings::uncounted_steps ==
              desmo::instructions::uncounted_steps);

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
    const int first = std::min(instructions::uncounted_steps, steps);
    const CheckMode check = bench::check_of(argv[3]);
    const std::string id(bench::formulation_of(argv[3]));
    const bench::Problem problem = regression::problem_of({argv[1], whole(argv[2]), id}, steps + 1);
    SteppedFormulation stepped(problem, id, settings);
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
    return desmo::bench::usage_error;
  }
}
