// Whole motions: instant after instant, or at once, and what is handed to the observer.

#include <algorithm>
#include <optional>

#include "formulations/stepping/dense_output.h"
#include "formulations/stepping/formulation.h"
#include "formulations/stepping/trajectory.h"

namespace desmo {

/// From the instant that was solved last, which is that of the grid's first or another from which
/// the drivers can go there straight.
std::optional<Summary> Formulation::run_at_once(const TimeGrid& grid, const Request& request,
                                                Observer& observer) {
  std::optional<Trajectory> kept;
  if (!observer.takes_any_order()) kept.emplace(grid.instants, model_.coordinates());
  const std::optional<Summary> total =
      whole_motion_->run(grid, request, state_, kept ? static_cast<Observer&>(*kept) : observer);
  if (!total) return {};
  forget();  // they have not come along
  now_ = {grid.time(grid.instants - 1), request.level};
  then_ = {};
  if (kept) kept->hand_on(observer);
  return total;
}

/// Solves the instant after the last, or assembles where there is none, and adds it to the total.
/// False: it failed.
bool Formulation::solve_next(int i, double t, const Request& request, Observer& observer,
                             Summary& total) {
  const Summary s = advance(t, request.level);
  total.time = t;
  total.iterations += s.iterations;
  total.updates += s.updates;
  if (!s.ok()) {
    total.status = s.status;
    total.group = s.group;
    total.constraint = s.constraint;
    total.residual = s.residual;
    return false;
  }
  ++total.instants;
  total.residual = std::max(total.residual, s.residual);
  if (wanted_.in_rooms) {
    Room room;
    observer.take_rooms({&i, 1}, {&room, 1});
    keepers_.fill(room, request.level, state_);
    observer.observe({i, t, {}, {}, {}, s.updates, s.residual, false, room});
    return true;
  }
  observer.observe({i, t, q(), request.level >= Level::velocity ? qd() : std::span<const double>{},
                    request.level >= Level::acceleration ? qdd() : std::span<const double>{},
                    s.updates, s.residual});
  return true;
}

Summary Formulation::solve_all(const TimeGrid& grid, const Request& request, Observer& observer) {
  if (whole_motion_) {
    if (grid.instants > 0 && assemble(grid.time(0), request.level).ok())
      if (const std::optional<Summary> total = run_at_once(grid, request, observer)) return *total;
    ++run_by_steps_;
  }
  assembled_ = false;
  return take_steps(grid, request, observer);
}

Summary Formulation::take_steps(const TimeGrid& grid, const Request& request, Observer& observer) {
  Summary total;
  want_as(request, observer);
  motions_.expect(grid);
  for (int i = 0; i < grid.instants; ++i)
    if (!solve_next(i, grid.time(i), request, observer, total)) break;
  write_kept(total);
  return total;
}

/// All of the instant solved last, whatever was wanted of it.
void Formulation::write_kept(const Summary& total) {
  if (total.ok() && total.instants > 0) keepers_.write(state_);
}

std::optional<Summary> Formulation::run_on(const TimeGrid& grid, const Request& request,
                                           Observer& observer) {
  if (whole_motion_) return run_at_once(grid, request, observer);
  const Summary total = take_steps(grid, request, observer);
  return total.ok() ? std::optional(total) : std::nullopt;
}

Summary Formulation::run(const TimeGrid& grid, const Request& request, Observer& observer) {
  if (settings_.stride == 1) return solve_all(grid, request, observer);
  const TimeGrid solved = grid.every(settings_.stride);
  const Request every_level{Level::acceleration, request.coordinates};
  DenseOutput all(grid, settings_.stride, request, model_.coordinates(), observer);
  Summary total = solve_all(solved, every_level, all);
  if (total.ok() && all.delivered() < grid.instants) {  // the rest, shorter than the stride
    want_as(every_level, all);
    solve_next(solved.instants, grid.time(grid.instants - 1), every_level, all, total);
    write_kept(total);
  }
  total.instants = all.delivered();
  return total;
}

}  // namespace desmo
