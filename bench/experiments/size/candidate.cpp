#include "bench/experiments/size/candidate.h"

#include <malloc.h>

#include <algorithm>
#include <exception>
#include <memory>
#include <stdexcept>

#include "bench/kit/delivery.h"
#include "bench/kit/memory/fresh_heap.h"
#include "bench/kit/time/cpu_clock.h"
#include "formulations/variants.h"

namespace desmo::size {

namespace {

long heap_bytes() {
  const struct mallinfo2 heap = mallinfo2();
  return static_cast<long>(heap.uordblks + heap.hblkhd);
}

std::unique_ptr<Formulation> make(const Configuration& c, const Model& m) {
  return make_formulation(*c.variant, m, c.settings);
}

}  // namespace

Contender::Contender(const Problem& problem, std::string_view name)
    : id(name),
      problem_(problem),
      configuration_(parse_id(name, {.tolerance = problem.tolerance})) {}

void Contender::verify() {
  try {
    compare();
  } catch (const std::exception& e) {
    message = e.what();
  }
  verified_ = true;
}

void Contender::compare() {
  const long before = heap_bytes();
  const auto formulation = make(configuration_, problem_.model);
  bytes = heap_bytes() - before;
  message = bench::missing_code(*formulation);
  if (!message.empty()) return;
  bench::VerifyingObserver observer(problem_.reference);
  const Summary summary = formulation->run(problem_.grid, {}, observer);
  errors = observer.errors();
  if (!summary.ok()) {
    message = describe(summary, problem_.model);
    return;
  }
  message = bench::verification_failure(errors, problem_.reference.size(),
                                        std::max(1.0, problem_.tolerance / Settings{}.tolerance));
  iterations_per_step =
      static_cast<double>(summary.iterations) / static_cast<double>(summary.instants);
  residual = summary.residual;
}

void Contender::time(double least) {
  if (!is_right()) return;
  try {
    bench::on_fresh_heap([&] { seconds_per_step.push_back(measure(least)); });
  } catch (const std::exception& e) {
    message = e.what();
    seconds_per_step.clear();
  }
}

double Contender::measure(double least) {
  const auto formulation = make(configuration_, problem_.model);
  formulation->assemble(problem_.grid.time(0));  // memory is touched for the first time
  bench::Delivery delivery(problem_.model.coordinates());
  const double start = bench::cpu_now();
  double spent = 0;
  long instants = 0;
  do {
    const Summary summary = formulation->run(problem_.grid, {}, delivery);
    if (!summary.ok()) throw std::runtime_error(describe(summary, problem_.model));
    instants += summary.instants;
    spent = bench::cpu_now() - start;
  } while (spent < least);
  return spent / static_cast<double>(instants);
}

}  // namespace desmo::size
