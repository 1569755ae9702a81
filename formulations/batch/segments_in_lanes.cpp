#include "formulations/batch/segments_in_lanes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include "formulations/base/output_writer.h"
#include "formulations/motion/driver_continuation.h"
#include "formulations/motion/prediction/driver_source.h"

namespace desmo {

SegmentsInLanes::SegmentsInLanes(const Model& model, std::vector<Parts> parts,
                                 const Settings& settings, const KernelTable& table)
    : model_(model),
      lanes_(static_cast<int>(parts.size())),
      motions_(driver_motions(model), lanes_, side_by_side(lanes_)),
      residual2_(lanes_),
      changes_(lanes_) {
  const std::size_t size = model_.state_size();
  first_positions_.resize(size * lanes_);
  alone_.resize(size);
  last_alone_.resize(size);

  std::vector<int> predicted, unwrapped;
  for (std::size_t i = 0; i < parts[0].size(); ++i) {
    if (parts[0][i].definition.constant) continue;
    const PartInLanes& part = parts_.emplace_back(put_in_lanes(parts, i, table));
    // A part that is solved lane by lane may start from any of its unknowns.
    PartInputs inputs{.predicted = part.unknowns, .unwrapped = {}, .others = {}, .drivers = {}};
    if (part.together) inputs = part.solvers[0]->inputs(std::move(inputs));
    std::ranges::copy(inputs.predicted, std::back_inserter(predicted));
    std::ranges::copy(inputs.unwrapped, std::back_inserter(unwrapped));
  }
  std::ranges::sort(predicted);
  state_ = BatchState(size, lanes_, settings.guess, predicted, std::move(unwrapped));
}

SegmentsInLanes::PartInLanes SegmentsInLanes::put_in_lanes(std::vector<Parts>& parts,
                                                           std::size_t index,
                                                           const KernelTable& table) const {
  PartInLanes part{.unknowns = parts[0][index].definition.unknowns};
  std::vector<ExplicitPart*> equal_parts;
  for (Parts& of_lane : parts) {
    part.solvers.push_back(std::move(of_lane[index].solver));
    equal_parts.push_back(dynamic_cast<ExplicitPart*>(part.solvers.back().get()));
  }
  if (const ExplicitPart* const any = equal_parts.front())
    if (const LaneKernel* k = table.find_lane_kernel(any->kernel().fingerprint, lanes_))
      part.together.emplace(*k, std::move(equal_parts),
                            std::vector<int>(any->places().begin(), any->places().end()));
  return part;
}

std::optional<Summary> SegmentsInLanes::run(const TimeGrid& grid, const Request& request,
                                            State& state, Observer& observer) {
  const int length = (grid.instants + lanes_ - 1) / lanes_;
  if (length < min_segment || !continue_to_segments(grid, length, state)) return {};
  requested_ = requested_coordinates(request, model_.coordinates());
  for (int& coordinate : requested_) coordinate *= lanes_;
  beyond_.resize(requested_.size());
  outputs_.clear();
  used_ = 0;

  Summary total;
  double max_residual2 = 0;
  for (int i = 0; i <= length; ++i) {  // the last one is the first instant of the next segment
    predict(grid.interval(), i);
    write_drivers(grid, length, i);
    const StepInLanes step = solve();
    if (!step.ok) return {};
    max_residual2 = std::max(max_residual2, *std::ranges::max_element(residual2_));
    if (i == 0) first_positions_ = state_.now().q;
    if (i == length) break;
    deliver(grid, length, i, request.level, step, observer, total);
    if (total.stopped) break;
  }
  total.residual = std::sqrt(max_residual2);
  if (total.stopped) return total;
  if (!meet()) return {};
  total.time = grid.time(grid.instants - 1);
  for (std::size_t k = 0; k < state.q.size(); ++k)
    copy_number(state_.now(), (k + 1) * lanes_ - 1, state, k);
  return total;
}

/// Moves all lanes at once from the first instant of the motion to the beginnings of their
/// segments, by continuation in equal steps. Rates are those of a way that takes a unit of time.
/// Returns false where a lane would need shorter steps or cannot be continued.
bool SegmentsInLanes::continue_to_segments(const TimeGrid& grid, int length, const State& first) {
  int steps = 1;
  for (int l = 0; l < lanes_; ++l) {
    for (const PartInLanes& part : parts_) part.solvers[l]->forget();
    alone_ = first;
    if (!solve_alone(l, alone_, first.q)) return false;  // this finds the branches
    for (std::size_t k = 0; k < alone_.q.size(); ++k)  // constant coordinates are not solved again
      state_.now().q[k * lanes_ + l] = state_.before().q[k * lanes_ + l] = alone_.q[k];
    desmo::write_drivers(model_, grid.time(l * length), alone_);
    changes_[l] = driver_changes(model_, first, alone_);
    steps = std::max(steps, continuation_steps(model_, changes_[l]));
    if (steps > max_continuation_steps) return false;
  }
  for (PartInLanes& part : parts_) {
    if (!part.together) continue;
    part.together->take_branches();
    if (!part.together->assembled()) return false;
  }
  const double step = 1.0 / steps;
  for (int i = 0; i <= steps; ++i) {
    predict(step, i);
    for (std::size_t d = 0; d < model_.drivers.size(); ++d) {
      const int driven = model_.entities[model_.drivers[d].coordinate].first;
      for (int l = 0; l < lanes_; ++l) {
        const std::size_t k = static_cast<std::size_t>(driven) * lanes_ + l;
        state_.now().q[k] = first.q[driven] + i * step * changes_[l][d];
        state_.now().qd[k] = changes_[l][d];
        state_.now().qdd[k] = 0;
      }
    }
    if (!solve().ok) return false;
  }
  return true;
}

bool SegmentsInLanes::solve_alone(int lane, State& state, std::span<const double> last) {
  for (const PartInLanes& part : parts_)
    if (part.solvers[lane]->solve(state, last, Level::position).status != Status::solved)
      return false;
  return true;
}

/// Predicts the next instant. h: time between instants; known: number of instants solved so far.
void SegmentsInLanes::predict(double h, int known) {
  const auto solved = [&](int least) {
    return known >= least ? std::optional(Level::acceleration) : std::nullopt;
  };
  state_.predict({h, h, solved(1), solved(2)});
}

void SegmentsInLanes::write_drivers(const TimeGrid& grid, int length, int i) {
  std::array<double, max_lanes> of_lanes;
  for (int l = 0; l < lanes_; ++l)
    of_lanes[l] = grid.time(std::min(l * length + i, grid.instants - 1));
  motions_({of_lanes.data(), of_lanes.data() + lanes_}, state_.now().q.data(),
           state_.now().qd.data(), state_.now().qdd.data());
}

SegmentsInLanes::StepInLanes SegmentsInLanes::solve() {
  const unsigned every_lane = (1u << lanes_) - 1;
  StepInLanes step;
  std::ranges::fill(residual2_, 0.0);
  for (PartInLanes& part : parts_) {
    unsigned accepted = 0;
    if (part.together) {
      alignas(64) std::array<double, max_lanes> residual2;
      const LaneResult r = part.together->solve(state_.now(), residual2.data());
      accepted = r.accepted;
      step.iterations = std::max(step.iterations, r.iterations);
      step.updates += static_cast<long>(r.iterations) * std::ssize(part.unknowns);
      for (int l = 0; l < lanes_; ++l)
        if (accepted >> l & 1) residual2_[l] += residual2[l];
    }
    if (accepted == every_lane) continue;
    for (int l = 0; l < lanes_; ++l)
      if (!(accepted >> l & 1)) solve_lane(part, l, step);
    if (!step.ok) break;
    if (part.together) part.together->take_branches();
  }
  return step;
}

/// Solves one lane alone. A lane that the code has refused starts from its last position; others
/// start from the prediction.
void SegmentsInLanes::solve_lane(PartInLanes& part, int lane, StepInLanes& step) {
  for (std::size_t k = 0; k < alone_.q.size(); ++k) {
    copy_number(state_.now(), k * lanes_ + lane, alone_, k);
    last_alone_[k] = state_.before().q[k * lanes_ + lane];
  }
  if (part.together)
    for (const int k : part.unknowns) alone_.q[k] = last_alone_[k];
  const PartResult r = part.solvers[lane]->solve(alone_, last_alone_, Level::acceleration);
  step.ok = step.ok && r.status == Status::solved;
  step.iterations = std::max(step.iterations, r.iterations);
  residual2_[lane] += r.residual2;
  for (const int k : part.unknowns)
    copy_number(alone_, k, state_.now(), static_cast<std::size_t>(k) * lanes_ + lane);
}

/// Returns whether each segment ended where the next had begun.
bool SegmentsInLanes::meet() const {
  const auto coordinates = static_cast<std::size_t>(model_.coordinates());
  std::vector<double> ended(coordinates), begun(coordinates);
  for (int l = 0; l + 1 < lanes_; ++l) {
    for (std::size_t k = 0; k < coordinates; ++k) {
      ended[k] = state_.now().q[k * lanes_ + l];
      begun[k] = first_positions_[k * lanes_ + l + 1];
    }
    if (!segments_meet(model_, ended, begun)) return false;
  }
  return true;
}

}  // namespace desmo
