#include "formulations/batch/lane_batch.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <set>
#include <utility>

namespace desmo {

namespace {

using Members = std::vector<const ExplicitPart*>;

Members members_of(const Copy& copy) {
  Members members;
  for (const auto& member : copy) members.push_back(member.get());
  return members;
}

/// Of all parts of a copy, ascending: components of an entity then follow each other.
std::vector<int> states_of(std::span<const ExplicitPart* const> copy) {
  std::set<int> states;
  for (const ExplicitPart* const part : copy)
    states.insert(part->places().begin(), part->places().end());
  return {states.begin(), states.end()};
}

int position_in(std::span<const int> ascending, int value) {
  return static_cast<int>(std::ranges::lower_bound(ascending, value) - ascending.begin());
}

/// For each state of the first copy that which stands in its place in another. Nothing where one
/// stands in two places.
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

bool are_copies(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b) {
  const auto type = [](const ExplicitPart* part) { return part->kernel().fingerprint; };
  return std::ranges::equal(a, b, {}, type, type) && places_in(b, a, states_of(a)) &&
         places_in(a, b, states_of(b));
}

LaneBatch::LaneBatch(std::span<Copy> copies, const CopyKernels& kernels,
                     const std::vector<StateKind>& kinds, Guess guess)
    : copies_(copies),
      lanes_(static_cast<std::size_t>(kernels.front()->lanes)),
      states_(std::make_unique<std::array<LaneState, 2>>()),
      now_(&states_->front()),
      before_(&states_->back()) {
  const Members first = members_of(copies.front());
  const std::vector<int> states = states_of(first);
  const auto copy_in = [&](std::size_t lane) -> Copy& {
    return copies[lane < copies.size() ? lane : 0];
  };
  for (std::size_t l = 0; l < lanes_; ++l)
    places_.push_back(places_in(members_of(copy_in(l)), first, states).value());

  std::set<int> read, unknowns, unwrapped;  // before any part has written them; written
  for (std::size_t j = 0; j < kernels.size(); ++j) {
    std::vector<ExplicitPart*> members;
    for (std::size_t l = 0; l < lanes_; ++l) members.push_back(copy_in(l)[j].get());
    std::vector<int> in;
    for (const int state : first[j]->places()) in.push_back(position_in(states, state));
    for (const int i : kernels[j]->read)
      if (!unknowns.contains(in[i])) read.insert(in[i]);
    for (const int i : kernels[j]->unknowns) unknowns.insert(in[i]);
    for (const int i : first[j]->kernel().angles) unwrapped.insert(in[i]);
    stages_.emplace_back(*kernels[j], std::move(members), std::move(in));
  }
  std::vector<int> once, moving, starts;
  for (const int n : read) {
    const auto all_are = [&](StateKind kind) {
      return std::ranges::all_of(
          places_, [&](const std::vector<int>& of_lane) { return kinds[of_lane[n]] == kind; });
    };
    (unknowns.contains(n)           ? starts
     : all_are(StateKind::constant) ? once
     : all_are(StateKind::driven)   ? driven_
                                    : moving)
        .push_back(n);
  }
  constants_ = LaneSources(once, places_);
  moving_ = LaneSources(moving, places_);
  undriven_ = LaneSources(driven_, places_);
  starts_ = LaneSources(starts, places_);
  unknowns_.assign(unknowns.begin(), unknowns.end());
  std::ranges::set_union(unknowns_, driven_, std::back_inserter(own_));
  unwrapped_.assign(unwrapped.begin(), unwrapped.end());
  std::erase_if(starts, [&](int n) { return unwrapped.contains(n); });
  std::vector<IndexRange> runs = runs_of(starts);
  for (IndexRange& run : runs)
    run = {run.first * static_cast<int>(lanes_), run.end * static_cast<int>(lanes_)};
  predictor_ = Predictor(guess, std::move(runs));

  for (LaneState* s : {now_, before_})
    for (LaneValues* values : {&s->q, &s->qd, &s->qdd}) values->resize(states.size() * lanes_);
  residuals2_.resize(stages_.size() * max_lanes);
  bind({std::vector<bool>(kinds.size(), true), {}, Level::acceleration});
}

std::vector<int> LaneBatch::drivers() const {
  std::vector<int> all;
  for (const int n : driven_)
    for (const std::vector<int>& of_lane : places_) all.push_back(of_lane[n]);
  return all;
}

/// Copies that are solved alone read more than kernels do.
std::vector<int> LaneBatch::reads() const {
  std::vector<int> all;
  for (const std::vector<int>& of_lane : places_)
    for (int n = 0; n < static_cast<int>(of_lane.size()); ++n)
      if (!std::ranges::binary_search(own_, n)) all.push_back(of_lane[n]);
  return all;
}

/// visit(in_lane, place): where each of these numbers of a lane stands in lanes and in the state.
template <class Visit>
void LaneBatch::for_numbers(std::span<const int> numbers, std::size_t lane, Visit&& visit) const {
  for (const int n : numbers) visit(n * lanes_ + lane, places_[lane][n]);
}

void LaneBatch::begin_step(const StepHistory& history, const MotionRow& row) {
  predicted_ = kept_ && history.last;
  if (predicted_) {
    std::swap(now_, before_);
    if (!predictor_.empty()) predictor_(history, *before_, *now_, now_->q.data());
    for (const int n : unwrapped_)
      std::copy_n(&before_->q[n * lanes_], lanes_, &now_->q[n * lanes_]);
  }
  lanes_ == 8 ? drive<8>(row) : drive<4>(row);
  is_driven_ = true;
}

template <std::size_t lanes>
void LaneBatch::drive(MotionRow row) {
  for (const int n : driven_) {
    copy_in_registers<lanes>(row.z, &now_->q[n * lanes]);
    copy_in_registers<lanes>(row.zd, &now_->qd[n * lanes]);
    copy_in_registers<lanes>(row.zdd, &now_->qdd[n * lanes]);
    row = row.from(lanes);
  }
}

const LaneBatch::Step& LaneBatch::solve(const State& s) {
  step_.accepted = assembled_ ? all() : 0;
  step_.iterations = 0;
  if (!std::exchange(is_driven_, false))
    undriven_.gather<3>({s.q.data(), s.qd.data(), s.qdd.data()},
                        {now_->q.data(), now_->qd.data(), now_->qdd.data()});
  if (!assembled_) return step_;
  if (!moving_.empty())
    moving_.gather<3>({s.q.data(), s.qd.data(), s.qdd.data()},
                      {now_->q.data(), now_->qd.data(), now_->qdd.data()});
  if (!predicted_) starts_.gather<1>({s.q.data()}, {now_->q.data()});
  double* of_stage = residuals2_.data();
  for (const LaneStage& stage : stages_) {
    const LaneResult r = stage.solve(*now_, of_stage);
    of_stage += max_lanes;
    // What is refused goes on without meaning, and never converges.
    if (step_.accepted == all()) step_.iterations = std::max(step_.iterations, r.iterations);
    step_.accepted &= r.accepted;
  }
  std::array<double, max_lanes> sums{};
  for (const double* r = residuals2_.data(); r != of_stage; r += max_lanes)
    for (int l = 0; l < max_lanes; ++l) sums[l] += r[l];
  step_.residual2 = sums;
  kept_ = true;
  return step_;
}

void LaneBatch::take(const State& s) {
  for (LaneState* values : {now_, before_}) constants_.gather<1>({s.q.data()}, {values->q.data()});
  for (std::size_t l = 0; l < lanes_; ++l)
    for_numbers(own_, l, [&](std::size_t in_lane, int place) {
      now_->q[in_lane] = s.q[place];
      now_->qd[in_lane] = s.qd[place];
      now_->qdd[in_lane] = s.qdd[place];
    });
  std::ranges::for_each(stages_, &LaneStage::take_branches);
  assembled_ = std::ranges::all_of(stages_, &LaneStage::assembled);
  kept_ = true;
}

void LaneBatch::write_observed(State& s, Level level) const {
  if (!predicted_)
    for (std::size_t l = 0; l < copies_.size(); ++l)
      for_numbers(own_, l, [&](std::size_t in_lane, int place) { s.q[place] = now_->q[in_lane]; });
  scatter(observed_, level, {predicted_ ? s.q.data() : nullptr, s.qd.data(), s.qdd.data()});
}

void LaneBatch::store(std::span<const int> numbers, std::size_t copy, State& s) const {
  for_numbers(numbers, copy, [&](std::size_t in_lane, int place) {
    s.q[place] = now_->q[in_lane];
    s.qd[place] = now_->qd[in_lane];
    s.qdd[place] = now_->qdd[in_lane];
  });
}

void LaneBatch::restore(std::size_t copy, std::span<double> q) const {
  for_numbers(own_, copy, [&](std::size_t in_lane, int place) { q[place] = before_->q[in_lane]; });
}

void LaneBatch::bind(const PartOutputs& outputs) {
  std::vector<int> in_state(outputs.observed.size());
  for (std::size_t i = 0; i < in_state.size(); ++i)
    in_state[i] = outputs.observed[i] ? static_cast<int>(i) : -1;
  observed_ = targets(unknowns_, in_state);
  // What is solved to a lower level has drivers up to that only.
  if (!outputs.places.empty())
    delivered_ = targets(outputs.level == Level::acceleration ? own_ : unknowns_, outputs.places);
}

/// Each place once: it becomes −1.
LaneTargets LaneBatch::targets(std::span<const int> numbers, std::span<int> places) const {
  LanePlaces to(lanes_, std::vector<int>(places_.front().size(), -1));
  for (std::size_t l = 0; l < copies_.size(); ++l)
    for (const int n : numbers) to[l][n] = std::exchange(places[places_[l][n]], -1);
  return {numbers, to, copies_.size()};
}

void LaneBatch::deliver(const OutputView& output, Level level) const {
  scatter(delivered_, level, output);
}

void LaneBatch::scatter(const LaneTargets& targets, Level level, const OutputView& to) const {
  std::array<LaneCopy, 3> copies;
  std::size_t count = 0;
  const auto add = [&](Level least, const LaneValues& values, double* array) {
    if (array && level >= least) copies[count++] = {values.data(), array};
  };
  add(Level::position, now_->q, to.q);
  add(Level::velocity, now_->qd, to.qd);
  add(Level::acceleration, now_->qdd, to.qdd);
  targets.scatter({copies.data(), count});
}

}  // namespace desmo
