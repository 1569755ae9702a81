// desmo_probe: what bench/check builds of both trees and puts questions to.
//   desmo_probe verify INSTANTS CELL...               a record of the cells, verified and not timed
//   desmo_probe time INSTANTS [--slow=CELL:PERCENT]   times cells as standard input asks
// --slow makes a cell slower on purpose, to test what is to find it. A question is a line CELL
// REPETITIONS PLACEMENT, where CELL may be "control"; the answer is the least CPU time of one
// analysis among the repetitions.

#include <algorithm>
#include <charconv>
#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/memory/kept_memory.h"
#include "bench/kit/time/cpu_clock.h"
#include "bench/regression/candidate.h"
#include "bench/regression/control.h"
#include "bench/regression/verified_record.h"
#include "formulations/algebra/blas.h"

namespace desmo::regression {

namespace {

int whole(std::string_view text, int least) {
  int value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc{} || stop != end || value < least || value > 1'000'000)
    throw std::invalid_argument("'" + std::string(text) + "' is not a whole number from " +
                                std::to_string(least) + " to 1e6");
  return value;
}

/// The least CPU time that one call takes among so many; a first one warms up.
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

/// Times cells, and makes one slower on purpose where --slow says so.
class Timer {
 public:
  Timer(int instants, std::string slowed, double percent)
      : instants_(instants), slowed_(std::move(slowed)), percent_(percent) {}

  double time(const std::string& name, int repetitions, int placement) const {
    if (name == "control")
      return min_seconds(repetitions, [] { control_result = control_kernel(); });
    // Where the cell's data lie beside cache lines and pages is luck; it is drawn anew every time.
    const std::vector<char> shift(16 * static_cast<std::size_t>(placement));
    Subject subject(parse_cell(name), instants_);
    const int last = subject.last_instant();
    const int extra = name == slowed_ ? extra_steps(last, percent_) : 0;
    return min_seconds(repetitions, [&] {
      Summary s = subject.analyse();
      if (s.ok() && extra > 0) s = subject.walk(last - 1, last - extra);
      if (!s.ok()) throw std::runtime_error(describe(s, subject.model()));
    });
  }

 private:
  static inline volatile double control_result;  // so that the kernel is not optimised away

  int instants_;
  std::string slowed_;
  double percent_;
};

void serve(const Timer& timer) {
  for (std::string name, repetitions, placement; std::cin >> name >> repetitions >> placement;) {
    const double seconds = timer.time(name, whole(repetitions, 1), whole(placement, 0));
    std::cout << seconds << std::endl;  // the other side waits for it
  }
}

int run(std::vector<std::string> arguments) {
  bench::keep_freed_memory();
  set_blas_threads(1);  // the clock is the thread's own
  std::cout.precision(9);
  const std::string command = arguments.empty() ? "" : arguments[0];
  if (command == "verify" && arguments.size() > 2) {
    std::cout << verified_record(whole(arguments[1], 2), {arguments.begin() + 2, arguments.end()})
              << '\n';
  } else if (command == "time" && (arguments.size() == 2 || arguments.size() == 3)) {
    std::string slowed;
    double percent = 0;
    if (arguments.size() == 3) {
      constexpr std::string_view option = "--slow=";
      const std::size_t colon = arguments[2].rfind(':');
      if (!arguments[2].starts_with(option) || colon == std::string::npos) return 64;
      slowed = arguments[2].substr(option.size(), colon - option.size());
      percent = whole(arguments[2].substr(colon + 1), 0);
    }
    serve(Timer(whole(arguments[1], 2), slowed, percent));
  } else {
    return 64;
  }
  return 0;
}

}  // namespace

}  // namespace desmo::regression

int main(int argc, char** argv) {
  try {
    const int code = desmo::regression::run({argv + 1, argv + argc});
    if (code == 64)
      std::cerr << "usage: desmo_probe verify INSTANTS CELL... | "
                   "time INSTANTS [--slow=CELL:PERCENT]\n";
    return code;
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_probe: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_probe: " << e.what() << '\n';
    return 1;
  }
}
