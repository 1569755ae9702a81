#include "formulations/lane_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <set>

namespace desmo {

namespace {

using Members = std::vector<const ExplicitPart*>;

Members members_of(const LanePart::Copy& copy) {
  Members members;
  for (const auto& member : copy) members.push_back(member.get());
  return members;
}

std::span<const int> inputs_of(const ExplicitPart& part) {
  return {part.binding().in, part.inputs()};
}

/// Of all parts of a copy, ascending: components of an entity then follow each other.
std::vector<int> states_of(std::span<const ExplicitPart* const> copy) {
  std::set<int> states;
  for (const ExplicitPart* const part : copy)
    for (const int state : inputs_of(*part)) states.insert(state);
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
    for (std::size_t i = 0; i < first[j]->inputs(); ++i) {
      int& place = places[position_in(states, inputs_of(*first[j])[i])];
      const int state = inputs_of(*other[j])[i];
      if (place >= 0 && place != state) return std::nullopt;
      place = state;
    }
  return places;
}

void append(PartResult& all, const PartResult& one, double& residual2) {
  residual2 += one.residual2;
  all.iterations = std::max(all.iterations, one.iterations);
  if (all.status == Status::converged) all.status = one.status;
}

}  // namespace

bool are_copies(std::span<const ExplicitPart* const> a, std::span<const ExplicitPart* const> b) {
  const auto type = [](const ExplicitPart* part) { return part->kernel().fingerprint; };
  return std::ranges::equal(a, b, {}, type, type) && places_in(b, a, states_of(a)) &&
         places_in(a, b, states_of(b));
}

LanePart::LanePart(std::vector<Kernels> kernels, std::vector<Copy> copies,
                   std::vector<bool> constant)
    : kernels_(std::move(kernels)),
      copies_(std::move(copies)),
      states_(states_of(members_of(copies_.front()))) {
  for (std::span<Copy> left = copies_; !left.empty();) {
    const Kernels& chosen = kernels_for(left.size());
    const std::size_t taken =
        std::min(left.size(), static_cast<std::size_t>(chosen.front()->lanes));
    batches_.push_back(make_batch(left.first(taken), chosen, constant));
    left = left.subspan(taken);
  }
}

/// Lanes left empty cost as much as others: as few as may be.
const LanePart::Kernels& LanePart::kernels_for(std::size_t copies) const {
  const auto hold_all = [&](const Kernels& k) {
    return static_cast<std::size_t>(k.front()->lanes) >= copies;
  };
  const auto narrowest = std::ranges::find_if(kernels_, hold_all);
  return narrowest == kernels_.end() ? kernels_.back() : *narrowest;
}

LanePart::Batch LanePart::make_batch(std::span<Copy> copies, const Kernels& kernels,
                                     const std::vector<bool>& constant) {
  const Members first = members_of(copies_.front());
  const auto lanes = static_cast<std::size_t>(kernels.front()->lanes);
  const auto copy_in = [&](std::size_t lane) -> Copy& {
    return copies[lane < copies.size() ? lane : 0];
  };
  std::vector<std::vector<int>> places;
  std::vector<const int*> place_of_lane;
  for (std::size_t l = 0; l < lanes; ++l)
    places.push_back(places_in(members_of(copy_in(l)), first, states_).value());
  for (const std::vector<int>& of_lane : places) place_of_lane.push_back(of_lane.data());

  std::vector<LaneStage> stages;
  std::set<int> positions, rates, unknowns;  // read before any part has written them
  for (std::size_t j = 0; j < kernels.size(); ++j) {
    std::vector<ExplicitPart*> members;
    for (std::size_t l = 0; l < lanes; ++l) members.push_back(copy_in(l)[j].get());
    std::vector<int> in;
    for (const int state : inputs_of(*first[j])) in.push_back(position_in(states_, state));
    for (const int i : kernels[j]->positions)
      if (!unknowns.contains(in[i])) positions.insert(in[i]);
    for (const int i : kernels[j]->rates)
      if (!unknowns.contains(in[i])) rates.insert(in[i]);
    for (const int i : kernels[j]->unknowns) unknowns.insert(in[i]);
    stages.emplace_back(*kernels[j], std::move(members), std::move(in));
  }
  const auto transport = [&](const std::set<int>& states) {
    return LanePlaces(std::vector<int>(states.begin(), states.end()), place_of_lane);
  };
  std::vector<bool> moving = constant;
  moving.flip();
  const LanePlaces all_positions = transport(positions), all_unknowns = transport(unknowns);
  LaneState local;
  for (LaneValues* values : {&local.q, &local.qd, &local.qdd})
    values->resize(states_.size() * lanes);
  return {copies,
          std::move(stages),
          all_positions.only(constant),
          all_positions.only(moving),
          transport(rates),
          all_unknowns,
          all_unknowns,
          std::move(local)};
}

PartResult LanePart::solve(State& s, std::span<const double> last, Level level) {
  PartResult result;
  double residual2 = 0;
  for (Batch& batch : batches_) solve(batch, s, last, level, result, residual2);
  result.residual2 = residual2;
  return result;
}

/// Copies of which every part is accepted, bit by bit. residual2: of each lane.
unsigned LanePart::solve_in_lanes(Batch& batch, PartResult& result, double* residual2) {
  alignas(64) std::array<double, most_lanes> of_stage;
  const unsigned all = (1u << batch.copies.size()) - 1;
  unsigned accepted = all;
  for (const LaneStage& stage : batch.stages) {
    const LaneResult r = stage.solve(batch.local, of_stage.data());
    // What is refused goes on without meaning, and never converges.
    if (accepted == all) result.iterations = std::max(result.iterations, r.iterations);
    accepted &= r.accepted;
    for (int l = 0; l < stage.kernel().lanes; ++l) residual2[l] += of_stage[l];
  }
  return accepted;
}

void LanePart::solve(Batch& batch, State& s, std::span<const double> last, Level level,
                     PartResult& result, double& residual2) {
  const auto take_branches = [&] {
    std::ranges::for_each(batch.stages, &LaneStage::take_branches);
  };
  if (!batch.assembled) {
    for (Copy& copy : batch.copies) solve_alone(copy, s, last, level, result, residual2);
    if (batch.copies.size() == 1) return;  // alone, now and always
    take_branches();
    batch.assembled = std::ranges::all_of(batch.stages, &LaneStage::assembled);
    batch.constants.gather(s.q.data(), batch.local.q.data());
    return;
  }
  LaneState& local = batch.local;
  batch.positions.gather(s.q.data(), local.q.data());
  batch.rates.gather(s.qd.data(), local.qd.data());
  batch.rates.gather(s.qdd.data(), local.qdd.data());
  alignas(64) std::array<double, most_lanes> residual2s{};
  const unsigned accepted = solve_in_lanes(batch, result, residual2s.data());
  batch.unknowns.scatter(local.q.data(), accepted, s.q.data());
  if (level >= Level::velocity) batch.unknowns_read.scatter(local.qd.data(), accepted, s.qd.data());
  if (level >= Level::acceleration)
    batch.unknowns_read.scatter(local.qdd.data(), accepted, s.qdd.data());
  bool refused = false;
  for (std::size_t l = 0; l < batch.copies.size(); ++l)
    if (accepted >> l & 1) {
      residual2 += residual2s[l];
    } else {
      solve_alone(batch.copies[l], s, last, level, result, residual2);
      refused = true;
    }
  if (refused) take_branches();
}

/// Up to the first part that cannot be solved: the next may need it.
void LanePart::solve_alone(Copy& copy, State& s, std::span<const double> last, Level level,
                           PartResult& result, double& residual2) {
  for (const auto& member : copy) {
    const PartResult r = member->solve(s, last, level);
    append(result, r, residual2);
    if (r.status != Status::converged) return;
  }
}

std::vector<int> LanePart::starts_from(const std::vector<int>& unknowns) const {
  std::vector<int> all;
  for (const Copy& copy : copies_)
    for (const auto& member : copy)
      std::ranges::copy(member->starts_from(unknowns), std::back_inserter(all));
  std::ranges::sort(all);
  return all;
}

void LanePart::write_only(const std::vector<bool>& read) {
  for (Batch& batch : batches_) batch.unknowns_read = batch.unknowns.only(read);
}

void LanePart::forget() {
  for (Batch& batch : batches_) batch.assembled = false;
  for (const Copy& copy : copies_)
    for (const auto& member : copy) member->forget();
}

long LanePart::fallbacks() const {
  long sum = 0;
  for (const Copy& copy : copies_)
    for (const auto& member : copy) sum += member->fallbacks();
  return sum;
}

long LanePart::branch_changes() const {
  long sum = 0;
  for (const Copy& copy : copies_)
    for (const auto& member : copy) sum += member->branch_changes();
  return sum;
}

}  // namespace desmo
