#include "bench/suite/cell.h"

#include <algorithm>
#include <ctime>
#include <exception>
#include <stdexcept>

#include "bench/suite/delivery.h"
#include "formulations/modelling/model.h"

namespace desmo::suite {

namespace {

constexpr int profiled_coordinates = 558;  // the largest of the paper's tables
constexpr int profiled_instants = 101;

double cpu_now() {
  timespec t{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// The counterparts of FBL-G and FBL-TP: the only ones run at extra sizes.
bool runs_at_extra_sizes(const Variant& v) {
  if (!v.backend) return true;
  return v.partition == Partition::global && v.evaluation == Evaluation::automatic &&
         !is_dense_global(v);
}

TimeGrid grid_of(const TimeGrid& own, const Options& o) {
  const double duration = own.time(own.instants - 1) - own.start;
  return time_grid(o.duration > 0 ? o.duration : duration, o.step > 0 ? o.step : own.step);
}

}  // namespace

Cell::Cell(const Case& d, int n, const Variant& v, const Options& options)
    : definition(d), coordinates(n), variant(v), grid(grid_of(d.describe(1).grid, options)) {
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
    mechanism_ = std::make_unique<Mechanism>(make_mechanism(describe(definition, coordinates)));
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
  } catch (const std::exception& e) {
    fail(e.what());
  }
}

void Cell::profile() {
  if (state != State::verified || coordinates != profiled_coordinates || !has_phases(variant))
    return;
  TimeGrid first = grid;
  first.instants = std::min(grid.instants, profiled_instants);
  phases = measure_phases(variant, *mechanism_, first);
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
        if (runs_at_extra_sizes(v)) cells.push_back(std::make_unique<Cell>(c, n, v, options));
  }
  for (const auto& cell : cells)  // a record has one time grid
    if (cell->grid.step != cells.front()->grid.step ||
        cell->grid.instants != cells.front()->grid.instants)
      throw std::invalid_argument(
          "the cases differ in step or duration: give --step and --duration");
  return cells;
}

}  // namespace desmo::suite
