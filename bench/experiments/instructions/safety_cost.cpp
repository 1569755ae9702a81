// desmo_safety_cost [CASE COORDINATES ID (bare|watched) STEPS]: what it costs to know how right
// every instant is. Without arguments CPU time a step of both cases with 558 coordinates, bare and
// watched (run_safely), interleaved; with them one such run and nothing else, for instruction
// counts.

#include <algorithm>
#include <cstdio>
#include <exception>
#include <iostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "bench/kit/cpu_clock.h"
#include "bench/kit/delivery.h"
#include "cases/cases.h"
#include "formulations/modelling/model.h"
#include "formulations/safety/safe_run.h"
#include "formulations/variants.h"

namespace {

using namespace desmo;

constexpr int usual_coordinates = 558, usual_steps = 3000, rounds = 7;

/// One case with one formulation, which takes its steps again and again.
class Subject {
 public:
  Subject(std::string_view case_name, int coordinates, std::string_view id, int steps)
      : mechanism_(make_mechanism(describe(find_case(case_name), coordinates))),
        formulation_(make_formulation(find_variant(id), mechanism_)),
        delivery_(mechanism_.coordinates()),
        grid_{0, 0.01, steps + 1} {}

  /// Microseconds a step.
  double time(bool watched) {
    const double begin = suite::cpu_now();
    run(watched);
    return 1e6 * (suite::cpu_now() - begin) / grid_.instants;
  }
  long assessed() const { return assessed_; }

 private:
  void run(bool watched) {
    if (watched) {
      const SafeSummary s = run_safely(*formulation_, grid_, {}, delivery_, {});
      assessed_ = s.assessed;
      if (s.outcome() != Outcome::converged)
        throw std::runtime_error("it is not an ordinary motion: " +
                                 describe_accuracy(s.condition, s.bound, Level::acceleration));
    } else if (const Summary s = formulation_->run(grid_, {}, delivery_); !s.ok()) {
      throw std::runtime_error(describe(s, mechanism_));
    }
  }

  Mechanism mechanism_;
  std::unique_ptr<Formulation> formulation_;
  suite::Delivery delivery_;
  TimeGrid grid_;
  long assessed_ = 0;
};

double median(std::vector<double> values) {
  std::ranges::nth_element(values, values.begin() + std::ssize(values) / 2);
  return values[values.size() / 2];
}

void compare(std::string_view case_name, std::string_view id) {
  Subject subject(case_name, usual_coordinates, id, usual_steps);
  std::vector<double> bare, watched, share;
  for (int i = 0; i < rounds; ++i) {
    bare.push_back(subject.time(false));
    watched.push_back(subject.time(true));
    share.push_back(watched.back() / bare.back() - 1);
  }
  std::printf("%-18s %-26s %10.2f %10.2f %8.1f %% %6ld\n", std::string(case_name).c_str(),
              std::string(id).c_str(), median(bare), median(watched), 100 * median(share),
              subject.assessed());
}

}  // namespace

int main(int argc, char** argv) {
  try {
    if (argc == 6) {
      Subject(argv[1], std::stoi(argv[2]), argv[3], std::stoi(argv[5]))
          .time(std::string_view(argv[4]) == "watched");
      return 0;
    }
    if (argc != 1)
      throw std::invalid_argument(
          "usage: desmo_safety_cost [CASE COORDINATES ID (bare|watched) STEPS]");
    std::printf("%-18s %-26s %10s %10s %10s %6s\n", "case", "formulation", "bare, us", "watched",
                "more", "assessed");
    for (const Case& c : cases())
      for (const char* id : {"global_automatic_klu", "group_symbolic_inlined",
                             "block_symbolic_inlined", "group_symbolic_explicit"})
        compare(c.name, id);
    return 0;
  } catch (const std::invalid_argument& e) {
    std::cerr << "desmo_safety_cost: " << e.what() << '\n';
    return 64;
  } catch (const std::exception& e) {
    std::cerr << "desmo_safety_cost: " << e.what() << '\n';
    return 1;
  }
}
