#include "formulations/batch/batch.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace desmo {

namespace {

using ExplicitParts = std::vector<const ExplicitPart*>;

ExplicitParts parts_in(const Subsystem& subsystem) {
  ExplicitParts parts;
  for (const auto& part : subsystem) parts.push_back(part.get());
  return parts;
}

/// Returns the positions in the state that the parts of a subsystem read or write, ascending.
/// Components of an entity then follow each other.
std::vector<int> places_of(std::span<const ExplicitPart* const> subsystem) {
  std::set<int> states;
  for (const ExplicitPart* const part : subsystem)
    states.insert(part->places().begin(), part->places().end());
  return {states.begin(), states.end()};
}

/// Returns the position in the state that another subsystem uses in place of each of `states`,
/// those of the first subsystem. Returns nothing where the other one uses two positions in place of
/// one.
std::optional<std::vector<int>> places_in(std::span<const ExplicitPart* const> other,
                                          std::span<const ExplicitPart* const> first,
                                          std::span<const int> states) {
  std::vector<int> places(states.size(), -1);
  for (std::size_t j = 0; j < first.size(); ++j)
    for (std::size_t i = 0; i < first[j]->places().size(); ++i) {
      int& place = places[position_in(states, first[j]->places()[i])];
      const int state = other[j]->places()[i];
      if (place >= 0 && place != state) return std::nullopt;
      place = state;
    }
  return places;
}

}  // namespace

bool are_alike(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b) {
  const auto type = [](const ExplicitPart* part) { return part->kernel().fingerprint; };
  return std::ranges::equal(a, b, {}, type, type) && places_in(b, a, places_of(a)) &&
         places_in(a, b, places_of(b));
}

Batch::Batch(std::span<Subsystem> subsystems, const SubsystemKernels& kernels,
             const std::vector<StateKind>& kinds, Guess guess)
    : subsystems_(subsystems), lanes_(static_cast<std::size_t>(kernels.front()->lanes)) {
  const ExplicitParts first = parts_in(subsystems.front());
  const std::vector<int> of_first = places_of(first);
  for (std::size_t l = 0; l < lanes_; ++l)
    places_.push_back(places_in(parts_in(subsystem_in(l)), first, of_first).value());

  const std::vector<Use> uses = add_parts(kernels, first, of_first);
  std::vector<int> once, moving, starts, predicted, unwrapped;
  for (int n = 0; n < static_cast<int>(uses.size()); ++n) {
    const auto [is_read, is_unknown, is_unwrapped] = uses[n];
    const auto all_are = [&](StateKind kind) {
      return std::ranges::all_of(
          places_, [&](const std::vector<int>& of_lane) { return kinds[of_lane[n]] == kind; });
    };
    if (is_unknown) unknowns_.push_back(n);
    if (is_unwrapped) unwrapped.push_back(n);
    if (!is_read) continue;
    if (is_unknown && !is_unwrapped) predicted.push_back(n);
    (is_unknown                     ? starts
     : all_are(StateKind::constant) ? once
     : all_are(StateKind::driven)   ? driven_
                                    : moving)
        .push_back(n);
  }
  constants_ = Gather(once, places_);
  moving_ = Gather(moving, places_);
  undriven_ = Gather(driven_, places_);
  starts_ = Gather(starts, places_);
  std::ranges::set_union(unknowns_, driven_, std::back_inserter(own_));
  state_ = BatchState(of_first.size(), lanes_, guess, predicted, std::move(unwrapped));
  residuals2_.resize(parts_.size() * max_lanes);
  bind({std::vector<bool>(kinds.size(), true), {}, Level::acceleration});
}

/// Makes the parts of the batch. Returns how they use each number.
std::vector<Batch::Use> Batch::add_parts(const SubsystemKernels& kernels,
                                         std::span<const ExplicitPart* const> first,
                                         std::span<const int> of_first) {
  std::vector<Use> uses(of_first.size());
  for (std::size_t j = 0; j < kernels.size(); ++j) {
    std::vector<ExplicitPart*> equal_parts;
    for (std::size_t l = 0; l < lanes_; ++l) equal_parts.push_back(subsystem_in(l)[j].get());
    std::vector<int> in;
    for (const int place : first[j]->places()) in.push_back(position_in(of_first, place));
    for (const int i : kernels[j]->read)
      if (!uses[in[i]].is_unknown) uses[in[i]].is_read = true;
    for (const int i : kernels[j]->unknowns) uses[in[i]].is_unknown = true;
    for (const int i : first[j]->kernel().angles) uses[in[i]].is_unwrapped = true;
    parts_.emplace_back(*kernels[j], std::move(equal_parts), std::move(in));
  }
  return uses;
}

std::vector<int> Batch::drivers() const {
  std::vector<int> all;
  for (const int n : driven_)
    for (const std::vector<int>& of_lane : places_) all.push_back(of_lane[n]);
  return all;
}

/// Returns the positions in the state of all numbers but unknowns and drivers. Subsystems that are
/// solved alone read more than kernels do.
std::vector<int> Batch::inputs() const {
  std::vector<int> all;
  for (const std::vector<int>& of_lane : places_)
    for (int n = 0; n < static_cast<int>(of_lane.size()); ++n)
      if (!std::ranges::binary_search(own_, n)) all.push_back(of_lane[n]);
  return all;
}

/// Calls visit(in_lane, place) for these numbers of a lane, with their positions in BatchState and
/// in the state.
template <class Visit>
void Batch::for_numbers(std::span<const int> numbers, std::size_t lane, Visit&& visit) const {
  for (const int n : numbers) visit(n * lanes_ + lane, places_[lane][n]);
}

void Batch::begin_step(const StepHistory& history, const MotionRow& row) {
  predicted_ = kept_ && history.last;
  if (predicted_) state_.predict(history);
  lanes_ == 8 ? write_drivers<8>(row) : write_drivers<4>(row);
  is_driven_ = true;
}

template <std::size_t lanes>
void Batch::write_drivers(MotionRow row) {
  for (const int n : driven_) {
    copy_in_registers<lanes>(row.z, &state_.now().q[n * lanes]);
    copy_in_registers<lanes>(row.zd, &state_.now().qd[n * lanes]);
    copy_in_registers<lanes>(row.zdd, &state_.now().qdd[n * lanes]);
    row = row.from(lanes);
  }
}

const Batch::Step& Batch::solve(const State& s) {
  step_.accepted = assembled_ ? all() : 0;
  step_.iterations = 0;
  if (!std::exchange(is_driven_, false))
    undriven_.gather<3>({s.q.data(), s.qd.data(), s.qdd.data()},
                        {state_.now().q.data(), state_.now().qd.data(), state_.now().qdd.data()});
  if (!assembled_) return step_;
  if (!moving_.empty())
    moving_.gather<3>({s.q.data(), s.qd.data(), s.qdd.data()},
                      {state_.now().q.data(), state_.now().qd.data(), state_.now().qdd.data()});
  if (!predicted_) starts_.gather<1>({s.q.data()}, {state_.now().q.data()});
  double* of_part = residuals2_.data();
  for (const KernelBatch& part : parts_) {
    const LaneResult r = part.solve(state_.now(), of_part);
    of_part += max_lanes;
    // A refused lane goes on with meaningless numbers and may never converge. A part reports only
    // the iterations of its slowest lane. So parts after the one that refused a lane do not count.
    if (step_.accepted == all()) step_.iterations = std::max(step_.iterations, r.iterations);
    step_.accepted &= r.accepted;
  }
  std::array<double, max_lanes> sums{};
  for (const double* r = residuals2_.data(); r != of_part; r += max_lanes)
    for (int l = 0; l < max_lanes; ++l) sums[l] += r[l];
  step_.residual2 = sums;
  kept_ = true;
  return step_;
}

void Batch::copy_from(const State& s) {
  for (LaneState* values : {&state_.now(), &state_.before()})
    constants_.gather<1>({s.q.data()}, {values->q.data()});
  for (std::size_t l = 0; l < lanes_; ++l)
    for_numbers(own_, l, [&](std::size_t in_lane, int place) {
      copy_number(s, place, state_.now(), in_lane);
    });
  std::ranges::for_each(parts_, &KernelBatch::take_branches);
  assembled_ = std::ranges::all_of(parts_, &KernelBatch::assembled);
  kept_ = true;
}

void Batch::write_observed(State& s, Level level) const {
  if (!predicted_)
    for (std::size_t l = 0; l < subsystems_.size(); ++l)
      for_numbers(own_, l,
                  [&](std::size_t in_lane, int place) { s.q[place] = state_.now().q[in_lane]; });
  scatter(observed_, level, {predicted_ ? s.q.data() : nullptr, s.qd.data(), s.qdd.data()});
}

void Batch::store(std::span<const int> numbers, std::size_t subsystem, State& s) const {
  for_numbers(numbers, subsystem, [&](std::size_t in_lane, int place) {
    copy_number(state_.now(), in_lane, s, place);
  });
}

void Batch::restore(std::size_t subsystem, std::span<double> q) const {
  for_numbers(own_, subsystem,
              [&](std::size_t in_lane, int place) { q[place] = state_.before().q[in_lane]; });
}

void Batch::bind(const PartOutputs& outputs) {
  std::vector<int> in_state(outputs.observed.size());
  for (std::size_t i = 0; i < in_state.size(); ++i)
    in_state[i] = outputs.observed[i] ? static_cast<int>(i) : -1;
  observed_ = targets(unknowns_, in_state);
  // Drivers are delivered only at accelerations, which no request exceeds. Below, a request of
  // drivers may have a higher level than that of the unknowns: others then deliver them.
  if (!outputs.places.empty())
    delivered_ = targets(outputs.level == Level::acceleration ? own_ : unknowns_, outputs.places);
}

/// Returns the table that scatters the local coordinates `numbers` of all subsystems. places: for
/// each position in the state the place in the target; −1: none. Each place is used once: it
/// becomes −1.
Scatter Batch::targets(std::span<const int> numbers, std::span<int> places) const {
  LanePlaces to(lanes_, std::vector<int>(places_.front().size(), -1));
  for (std::size_t l = 0; l < subsystems_.size(); ++l)
    for (const int n : numbers) to[l][n] = std::exchange(places[places_[l][n]], -1);
  return {numbers, to, subsystems_.size()};
}

void Batch::deliver(const OutputView& output, Level level) const {
  scatter(delivered_, level, output);
}

void Batch::scatter(const Scatter& targets, Level level, const OutputView& to) const {
  std::array<LaneCopy, 3> copies;
  std::size_t count = 0;
  const auto add = [&](Level least, const LaneValues& values, double* array) {
    if (array && level >= least) copies[count++] = {values.data(), array};
  };
  add(Level::position, state_.now().q, to.q);
  add(Level::velocity, state_.now().qd, to.qd);
  add(Level::acceleration, state_.now().qdd, to.qdd);
  targets.scatter({copies.data(), count});
}

}  // namespace desmo
