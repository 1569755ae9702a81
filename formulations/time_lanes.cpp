#include "formulations/time_lanes.h"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "formulations/guess.h"
#include "formulations/lane_transport.h"
#include "formulations/same_position.h"
#include "formulations/straight_way.h"

namespace desmo {

namespace {

Lanes with(const Lanes& lanes, int lane, double value) {
  return Lanes([&](auto l) { return static_cast<int>(l) == lane ? value : lanes[l]; });
}

}  // namespace

TimeLanes::TimeLanes(const Mechanism& mechanism, std::array<Parts, lane_count> parts,
                     const Settings& settings, const KernelTable& table)
    : mechanism_(mechanism), settings_(settings), parts_(std::move(parts)) {
  const std::size_t size = mechanism_.state_size();
  for (LaneState* s : {&now_, &before_})
    for (std::vector<Lanes>* values : {&s->q, &s->qd, &s->qdd}) values->resize(size, Lanes(0.0));
  estimate_.resize(size, Lanes(0.0));
  entered_.resize(size, Lanes(0.0));
  for (std::vector<double>* values : {&alone_.q, &alone_.qd, &alone_.qdd}) values->resize(size);
  for (State& s : delivered_)
    for (std::vector<double>* values : {&s.q, &s.qd, &s.qdd})
      values->resize(mechanism_.coordinates());

  std::vector<int> started_from;
  for (std::size_t i = 0; i < parts_[0].size(); ++i) {
    const PartDefinition& definition = parts_[0][i].definition;
    if (definition.constant) continue;
    stages_.push_back(make_stage(i, table));
    std::ranges::copy(parts_[0][i].solver->starts_from(definition.unknowns),
                      std::back_inserter(started_from));
  }
  for (Stage& s : stages_)  // where its numbers now stay
    if (s.kernel)
      s.binding = {static_cast<ExplicitPart*>(s.members[0])->binding().in,
                   s.c.data(),
                   s.f.data(),
                   s.branch.data(),
                   s.w.data(),
                   static_cast<ExplicitPart*>(s.members[0])->binding().limits};
  std::ranges::sort(started_from);
  started_from_ = runs_of(started_from);
}

TimeLanes::Stage TimeLanes::make_stage(std::size_t part, const KernelTable& table) const {
  Stage stage;
  stage.unknowns = parts_[0][part].definition.unknowns;
  for (int l = 0; l < lane_count; ++l) stage.members[l] = parts_[l][part].solver.get();
  const auto* explicit_part = dynamic_cast<const ExplicitPart*>(stage.members[0]);
  if (!explicit_part) return stage;
  stage.kernel = table.find_lane_kernel(explicit_part->kernel().fingerprint);
  if (!stage.kernel) return stage;
  const auto& [in, c, f, branch, w, limits] = explicit_part->binding();
  stage.c.assign(c, c + explicit_part->constants());
  stage.f.assign(f, f + explicit_part->kernel().folded);
  stage.w.assign(w, w + explicit_part->equations());
  stage.branch.resize(explicit_part->branches().size());
  return stage;
}

std::optional<Summary> TimeLanes::run(const TimeGrid& grid, const Request& request, State& state,
                                      Sink& sink) {
  const int length = (grid.instants + lane_count - 1) / lane_count;
  if (length < shortest_segment || !enter(grid, length, state)) return {};

  Summary total;
  Lanes residual2 = 0;
  for (int i = 0; i <= length; ++i) {  // up to the first instant of the next segment
    guess(grid.interval(), std::min(i, 2));
    drive(grid, length, i);
    const Step step = solve();
    if (!step.ok) return {};
    residual2 = std::experimental::max(residual2, step.residual2);
    if (i == 0) entered_ = now_.q;
    if (i == length) break;
    total.iterations += static_cast<long>(step.iterations) * lane_count;
    total.updates += step.updates * lane_count;
    deliver(grid, length, i, request, step, sink);
  }
  if (!meet()) return {};
  total.instants = grid.instants;
  total.time = grid.time(grid.instants - 1);
  total.residual = std::sqrt(hmax(residual2));
  for (std::size_t k = 0; k < state.q.size(); ++k) {
    state.q[k] = now_.q[k][lane_count - 1];
    state.qd[k] = now_.qd[k][lane_count - 1];
    state.qdd[k] = now_.qdd[k][lane_count - 1];
  }
  return total;
}

/// Each lane at the position from which the first instant of its segment is solved.
bool TimeLanes::enter(const TimeGrid& grid, int length, const State& first) {
  for (int l = 0; l < lane_count; ++l) {
    for (const Formulation::DefinedPart& part : parts_[l]) part.solver->forget();
    alone_ = first;
    const auto solve = [&](State& state) { return solve_alone(l, state, Level::position); };
    if (!go_straight(mechanism_, grid.time(l * length), alone_, solve)) return false;
    pack(l, alone_);
  }
  pack_branches();
  return std::ranges::all_of(stages_, [](const Stage& stage) {
    return !stage.kernel || std::ranges::all_of(stage.members, [](const Part* member) {
      return static_cast<const ExplicitPart*>(member)->assembled();
    });
  });
}

bool TimeLanes::solve_alone(int lane, State& state, Level level) {
  for (const Stage& stage : stages_)
    if (stage.members[lane]->solve(state, level).status != Status::converged) return false;
  return true;
}

void TimeLanes::pack(int lane, const State& from) {
  for (std::size_t k = 0; k < from.q.size(); ++k) {
    now_.q[k] = with(now_.q[k], lane, from.q[k]);
    before_.q[k] = with(before_.q[k], lane, from.q[k]);  // of what never moves
  }
}

void TimeLanes::pack_branches() {
  for (Stage& stage : stages_)
    if (stage.kernel) pack_branches(stage);
}

void TimeLanes::pack_branches(Stage& stage) {
  for (std::size_t k = 0; k < stage.branch.size(); ++k)
    stage.branch[k] = Lanes([&](auto lane) {
      return static_cast<const ExplicitPart*>(stage.members[lane])->branches()[k];
    });
}

/// Leaves the last instant in before_ and the guess in now_. known: how many instants were solved.
void TimeLanes::guess(double h, int known) {
  std::ranges::copy(now_.q, estimate_.begin());
  if (known > 0) {
    const Past past{h, h, Level::acceleration,
                    known > 1 ? std::optional(Level::acceleration) : std::nullopt};
    const Extrapolation extrapolated(best_guess(settings_.guess, past), past);
    for (const CoordinateRun run : started_from_)
      extrapolated(run, now_, before_, estimate_.data());
  }
  std::swap(now_, before_);
  std::swap(now_.q, estimate_);
}

void TimeLanes::drive(const TimeGrid& grid, int length, int i) {
  for (const Driver& d : mechanism_.drivers) {
    const int k = mechanism_.entities[d.coordinate].first;
    std::array<MotionSample<double>, lane_count> z;
    for (int l = 0; l < lane_count; ++l)
      z[l] = sample(d.motion, grid.time(std::min(l * length + i, grid.instants - 1)));
    now_.q[k] = Lanes([&](auto lane) { return z[lane].position; });
    now_.qd[k] = Lanes([&](auto lane) { return z[lane].velocity; });
    now_.qdd[k] = Lanes([&](auto lane) { return z[lane].acceleration; });
  }
}

TimeLanes::Step TimeLanes::solve() {
  Step step;
  for (Stage& stage : stages_) {
    if (stage.kernel) {
      const ExplicitResult<Lanes> r =
          stage.kernel->solve(now_.q.data(), now_.qd.data(), now_.qdd.data(), stage.binding);
      step.iterations = std::max(step.iterations, r.iterations);
      step.updates += static_cast<long>(r.iterations) * std::ssize(stage.unknowns);
      where(r.accepted, step.residual2) += r.residual2;
      if (all(r.accepted)) continue;
      for (int l = 0; l < lane_count; ++l)
        if (!r.accepted[l]) solve_lane(stage, l, step);
      pack_branches(stage);
    } else {
      for (int l = 0; l < lane_count; ++l) solve_lane(stage, l, step);
    }
    if (!step.ok) break;
  }
  return step;
}

/// From the last position, for what was guessed may be overwritten.
void TimeLanes::solve_lane(Stage& stage, int lane, Step& step) {
  for (std::size_t k = 0; k < alone_.q.size(); ++k) {
    alone_.q[k] = now_.q[k][lane];
    alone_.qd[k] = now_.qd[k][lane];
    alone_.qdd[k] = now_.qdd[k][lane];
  }
  if (stage.kernel)
    for (const int k : stage.unknowns) alone_.q[k] = before_.q[k][lane];
  const PartResult r = stage.members[lane]->solve(alone_, Level::acceleration);
  step.ok = step.ok && r.status == Status::converged;
  step.iterations = std::max(step.iterations, r.iterations);
  step.residual2[lane] += r.residual * r.residual;
  for (const int k : stage.unknowns) {
    now_.q[k][lane] = alone_.q[k];
    now_.qd[k][lane] = alone_.qd[k];
    now_.qdd[k][lane] = alone_.qdd[k];
  }
}

/// Whether each segment ended where the next had begun.
bool TimeLanes::meet() const {
  const auto coordinates = static_cast<std::size_t>(mechanism_.coordinates());
  std::vector<double> ended(coordinates), begun(coordinates);
  for (int l = 0; l + 1 < lane_count; ++l) {
    for (std::size_t k = 0; k < coordinates; ++k) {
      ended[k] = now_.q[k][l];
      begun[k] = entered_[k][l + 1];
    }
    if (!same_position(mechanism_, ended, begun)) return false;
  }
  return true;
}

void TimeLanes::deliver(const TimeGrid& grid, int length, int i, const Request& request,
                        const Step& step, Sink& sink) {
  const auto unpacked = [&](const std::vector<Lanes>& from, std::vector<double> State::*to) {
    std::array<double*, lane_count> lanes;
    for (int l = 0; l < lane_count; ++l) lanes[l] = (delivered_[l].*to).data();
    if (request.coordinates.empty())
      unpack(std::span(from).first(mechanism_.coordinates()), lanes);
    else
      unpack(from, request.coordinates, lanes);
  };
  unpacked(now_.q, &State::q);
  if (request.level >= Level::velocity) unpacked(now_.qd, &State::qd);
  if (request.level >= Level::acceleration) unpacked(now_.qdd, &State::qdd);
  for (int l = 0; l < lane_count; ++l) {
    const int index = l * length + i;
    if (index >= grid.instants) break;
    const State& s = delivered_[l];
    const std::span<const double> none;
    sink.accept({index, grid.time(index), s.q, request.level >= Level::velocity ? s.qd : none,
                 request.level >= Level::acceleration ? s.qdd : none, step.updates,
                 std::sqrt(step.residual2[l])});
  }
}

}  // namespace desmo
