// desmo_probe: the program that bench/check builds in both trees. It answers questions.
//   desmo_probe names                                 the candidates that bench/check measures
//   desmo_probe verify INSTANTS NAME...               a record of candidates, verified, not timed
//   desmo_probe time INSTANTS [NAME PERCENT]          times candidates as standard input asks,
//                                                   NAME by PERCENT slower, to test the check
// A question of `time` is a line NAME REPETITIONS PLACEMENT, where NAME may be "control". The
// candidate's data are moved in memory by 16 · PLACEMENT bytes. The answer is the least CPU time of
// one analysis among the repetitions [s].

#include <algorithm>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <vector>

#include "bench/kit/candidate_name.h"
#include "bench/kit/exit_codes.h"
#include "bench/kit/memory.h"
#include "bench/kit/time/clock.h"
#include "bench/regression/measured_candidates.h"
#include "bench/regression/rounds.h"
#include "bench/regression/stepped_formulation.h"
#include "formulations/algebra/blas.h"

namespace desmo::regression {

namespace {

constexpr int max_number = 1'000'000;

constexpr int size = 32, sweeps = 300;  // size of the control's matrix, number of products with it

/// The control's data. They begin a page of memory, like the code below, so that times do not
/// depend on where a build happens to put them.
struct alignas(4096) ControlData {
  double a[size][size];
  double x[size], y[size];
} data;

/// Does a fixed amount of dense arithmetic that has nothing to do with what is measured: a change
/// in its time is the machine's doing. Returns a value that depends on all of it. It repeats
/// x ← A x / 2 with rows of A that sum to 2, so that x neither vanishes nor overflows.
__attribute__((noinline, aligned(4096))) double control_kernel() {
  for (int i = 0; i < size; ++i) {
    for (int j = 0; j < size; ++j) data.a[i][j] = 1.0 / size + (i == j ? 1.0 : 0.0);
    data.x[i] = 1 + i;
  }
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    for (int i = 0; i < size; ++i) {
      double sum = 0;
      for (int j = 0; j < size; ++j) sum += data.a[i][j] * data.x[j];
      data.y[i] = sum / 2;
    }
    for (int i = 0; i < size; ++i) data.x[i] = data.y[i];
  }
  return data.x[0];
}

/// Returns the least CPU time [s] of a call among all repetitions; a first one warms up.
template <class Call>
double min_seconds(int repetitions, const Call& call) {
  call();
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < repetitions; ++i) {
    const double before = bench::cpu_now();
    call();
    least = std::min(least, bench::cpu_now() - before);
  }
  return least;
}

volatile double control_result;  // so that the kernel is not optimised away

/// Returns the least CPU time [s] of an analysis among all repetitions. percent: by how much the
/// analysis is made slower on purpose; the control never is.
double time(const std::string& name, int instants, double percent, int repetitions, int placement) {
  if (name == control_name)
    return min_seconds(repetitions, [] { control_result = control_kernel(); });
  // Places of data in cache lines and pages change times by chance. So desmo_check draws another
  // placement for each question.
  const std::vector<char> shift(16 * static_cast<std::size_t>(placement));
  const bench::CandidateName parsed = bench::parse_name(name);
  const bench::Problem problem = problem_of(parsed, instants);
  SteppedFormulation stepped(problem, parsed.id);
  const int last = instants - 1, extra = extra_steps(last, percent);
  return min_seconds(repetitions, [&] {
    Summary s = stepped.run();
    if (s.ok() && extra > 0) s = stepped.walk(last - 1, last - extra);
    if (!s.ok()) throw std::runtime_error(describe(s, problem.plan.model));
  });
}

/// Answers the questions on standard input. slowed: the candidate that is made slower by a
/// percentage; empty: none.
void serve(int instants, const std::string& slowed, double percent) {
  for (std::string name, repetitions, placement; std::cin >> name >> repetitions >> placement;) {
    const double seconds = time(name, instants, name == slowed ? percent : 0,
                                bench::whole_number(repetitions, 1, max_number),
                                bench::whole_number(placement, 0, max_number));
    std::cout << seconds << std::endl;  // flushed, since desmo_check waits for it
  }
}

int run(std::vector<std::string> arguments) {
  bench::keep_freed_memory();
  set_blas_threads(1);  // cpu_now() counts this thread alone
  std::cout.precision(9);
  const std::string command = arguments.empty() ? "" : arguments[0];
  if (command == "names" && arguments.size() == 1) {
    for (const std::string& name : measured_candidates()) std::cout << name << '\n';
  } else if (command == "verify" && arguments.size() > 2) {
    std::cout << verified_record(bench::whole_number(arguments[1], 2, max_number),
                                 {arguments.begin() + 2, arguments.end()})
              << '\n';
  } else if (command == "time" && (arguments.size() == 2 || arguments.size() == 4)) {
    const bool slowed = arguments.size() == 4;
    serve(bench::whole_number(arguments[1], 2, max_number), slowed ? arguments[2] : "",
          slowed ? bench::whole_number(arguments[3], 0, max_number) : 0);
  } else {
    return bench::usage_error;
  }
  return 0;
}

}  // namespace

}  // namespace desmo::regression

int main(int argc, char** argv) {
  try {
    const int code = desmo::regression::run({argv + 1, argv + argc});
    if (code == desmo::bench::usage_error)
      std::cerr << "usage: desmo_probe names | verify INSTANTS NAME... | "
                   "time INSTANTS [NAME PERCENT]\n";
    return code;
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_probe: " << e.what() << '\n';
    return desmo::bench::usage_error;
  } catch (const std::exception& e) {
    std::cerr << "desmo_probe: " << e.what() << '\n';
    return 1;
  }
}
