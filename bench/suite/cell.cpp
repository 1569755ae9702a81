#include "bench/suite/cell.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <string_view>

#include "bench/suite/delivery.h"

namespace desmo::suite {

namespace {

constexpr int profiled_coordinates = 558;  // the largest of the paper's tables
constexpr int profiled_instants = 301;

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The formulations that the paper has times for: the only ones run at extra sizes.
bool is_of_the_paper(const Variant& v) {
  const std::string_view algebra = algebra_name(v);
  return (v.partition == Partition::global && v.id.starts_with("global_automatic")) ||
         algebra == "inlined";
}

TimeGrid grid_of(const Case& c, const Options& o) {
  return time_grid(o.duration > 0 ? o.duration : c.seconds, o.step > 0 ? o.step : c.step);
}

}  // namespace

Cell::Cell(const Case& d, int n, const Variant& v, const Options& options)
    : definition(d), coordinates(n), variant(v), grid(grid_of(d, options)) {
  if (is_dense_global(v) && n > options.dense_limit) {
    state = State::not_run;
    message = "a dense global solve costs O(n^3) a step: run up to " +
              std::to_string(options.dense_limit) + " coordinates only";
  }
}

std::string Cell::name() const {
  return std::string(definition.name) + "/" + std::to_string(coordinates) + "/" + variant.id;
}

void Cell::fail(std::string why) {
  state = State::failed;
  message = std::move(why);
}

void Cell::verify(ReferenceCache& references) {
  if (state != State::untouched) return;
  try {
    mechanism_ = std::make_unique<Mechanism>(build(definition, coordinates));
    groups = mechanism_->structural_groups();
    degrees_of_freedom = mechanism_->degrees_of_freedom();
    const double before_setup = cpu_now();
    formulation_ = make_formulation(variant, *mechanism_);
    setup_seconds = cpu_now() - before_setup;
    delivery_ = std::make_unique<Delivery>(coordinates);

    const auto reference = references.get(*mechanism_, grid);
    VerifyingSink sink(reference);
    const Summary summary = formulation_->run(grid, {}, sink);
    errors = sink.errors();
    if (!summary.ok()) return fail(describe(summary, *mechanism_));
    if (const std::string wrong = complaint(errors, reference.size()); !wrong.empty())
      return fail(wrong);
    iterations_per_step = static_cast<double>(summary.iterations) / summary.instants;
    residual = summary.residual;
    state = State::verified;

    if (coordinates == profiled_coordinates && has_phases(variant)) {
      TimeGrid first = grid;
      first.instants = std::min(grid.instants, profiled_instants);
      phases = measure_phases(variant, *mechanism_, first);
    }
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

Summary Cell::analyse() {
  const Summary summary = formulation_->run(grid, {}, *delivery_);
  if (!summary.ok()) fail(describe(summary, *mechanism_));
  return summary;
}

std::vector<std::unique_ptr<Cell>> make_cells(const Options& options) {
  std::vector<std::unique_ptr<Cell>> cells;
  for (const Case& c : cases()) {
    for (const int n : c.sizes)
      for (const Variant& v : variants()) cells.push_back(std::make_unique<Cell>(c, n, v, options));
    for (const int n : c.extra_sizes)
      for (const Variant& v : variants())
        if (is_of_the_paper(v) && !is_dense_global(v))
          cells.push_back(std::make_unique<Cell>(c, n, v, options));
  }
  return cells;
}

}  // namespace desmo::suite
