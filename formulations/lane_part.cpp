#include "formulations/lane_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

namespace desmo {

namespace {

/// One behind the other the elements of each array, side by side.
LaneValues side_by_side(const std::vector<const double*>& arrays, std::size_t count) {
  LaneValues result;
  for (std::size_t k = 0; k < count; ++k)
    for (const double* const array : arrays) result.push_back(array[k]);
  return result;
}

/// The widest: what rounding leaves is not the same for all.
ExplicitLimits limits_of(const std::vector<ExplicitPart*>& members) {
  const auto limits = [](const ExplicitPart* member) { return member->binding().limits; };
  return limits(*std::ranges::max_element(
      members, {}, [&](const ExplicitPart* member) { return limits(member).tolerance2; }));
}

void append(PartResult& all, const PartResult& one, double& residual2) {
  residual2 += one.residual * one.residual;
  all.iterations = std::max(all.iterations, one.iterations);
  if (all.status == Status::converged) all.status = one.status;
}

}  // namespace

LanePart::LanePart(std::vector<const LaneKernel*> kernels,
                   std::vector<std::unique_ptr<ExplicitPart>> members)
    : kernels_(std::move(kernels)), members_(std::move(members)) {
  const std::size_t inputs = members_.front()->inputs();
  identity_.resize(inputs);
  std::iota(identity_.begin(), identity_.end(), 0);
  for (LaneValues* values : {&local_.q, &local_.qd, &local_.qdd})
    values->resize(inputs * kernels_.back()->lanes);
  for (std::size_t first = 0; first < members_.size(); first += batches_.back().members.size())
    batches_.push_back(make_batch(first));
  for (Batch& b : batches_)
    b.binding = {identity_.data(), b.c.data(), b.f.data(),
                 b.branch.data(),  b.w.data(), limits_of(b.members)};
}

/// Lanes left empty cost as much as others: as few as may be.
const LaneKernel& LanePart::kernel_for(std::size_t members) const {
  const auto holds_all = [&](const LaneKernel* k) {
    return static_cast<std::size_t>(k->lanes) >= members;
  };
  const auto narrowest = std::ranges::find_if(kernels_, holds_all);
  return narrowest == kernels_.end() ? *kernels_.back() : **narrowest;
}

LanePart::Batch LanePart::make_batch(std::size_t first) {
  const LaneKernel& kernel = kernel_for(members_.size() - first);
  std::vector<ExplicitPart*> members;
  std::vector<const int*> in;
  std::vector<const double*> c, f, w;
  for (std::size_t l = 0; l < static_cast<std::size_t>(kernel.lanes); ++l) {
    const bool own = first + l < members_.size();
    ExplicitPart& member = *members_[own ? first + l : first];
    if (own) members.push_back(&member);
    in.push_back(member.binding().in);
    c.push_back(member.binding().c);
    f.push_back(member.binding().f);
    w.push_back(member.binding().w);
  }
  Batch batch{.kernel = kernel,
              .members = std::move(members),
              .positions = {kernel.positions, in},
              .rates = {kernel.rates, in},
              .unknowns = {kernel.unknowns, in}};
  const ExplicitPart& any = *members_.front();
  batch.c = side_by_side(c, any.constants());
  batch.f = side_by_side(f, any.kernel().folded);
  batch.w = side_by_side(w, any.equations());
  batch.branch.resize(any.kernel().branches.size() * kernel.lanes);
  return batch;
}

PartResult LanePart::solve(State& s, Level level) {
  PartResult result;
  double residual2 = 0;
  for (Batch& batch : batches_) solve(batch, s, level, result, residual2);
  result.residual = std::sqrt(residual2);
  return result;
}

void LanePart::solve(Batch& batch, State& s, Level level, PartResult& result, double& residual2) {
  const bool ready =
      batch.members.size() > 1 && std::ranges::all_of(batch.members, &ExplicitPart::assembled);
  if (!ready) {
    for (ExplicitPart* member : batch.members) append(result, member->solve(s, level), residual2);
    if (batch.members.size() > 1) pack_branches(batch);
    return;
  }
  auto& [q, qd, qdd] = local_;
  batch.positions.gather(s.q.data(), q.data());
  batch.rates.gather(s.qd.data(), qd.data());
  batch.rates.gather(s.qdd.data(), qdd.data());

  alignas(64) std::array<double, most_lanes> residual2s;
  const LaneResult r =
      batch.kernel.solve(q.data(), qd.data(), qdd.data(), batch.binding, residual2s.data());

  // What fills the rest is written like the first.
  const unsigned own = (1u << batch.members.size()) - 1,
                 every_lane = (1u << batch.kernel.lanes) - 1;
  const unsigned accepted = (r.accepted & own) | (r.accepted & 1 ? every_lane & ~own : 0u);
  batch.unknowns.scatter(q.data(), accepted, s.q.data());
  if (level >= Level::velocity) batch.unknowns.scatter(qd.data(), accepted, s.qd.data());
  if (level >= Level::acceleration) batch.unknowns.scatter(qdd.data(), accepted, s.qdd.data());
  result.iterations = std::max(result.iterations, r.iterations);
  for (std::size_t l = 0; l < batch.members.size(); ++l)
    if (accepted >> l & 1)
      residual2 += residual2s[l];
    else
      append(result, batch.members[l]->solve(s, level), residual2);
  if (accepted != every_lane) pack_branches(batch);
}

void LanePart::pack_branches(Batch& batch) const {
  const std::size_t lanes = batch.kernel.lanes;
  for (std::size_t l = 0; l < lanes; ++l) {
    const auto branches = batch.members[l < batch.members.size() ? l : 0]->branches();
    for (std::size_t k = 0; k < branches.size(); ++k) batch.branch[k * lanes + l] = branches[k];
  }
}

std::vector<int> LanePart::starts_from(const std::vector<int>& unknowns) const {
  std::vector<int> all;
  for (const auto& member : members_)
    std::ranges::copy(member->starts_from(unknowns), std::back_inserter(all));
  std::ranges::sort(all);
  return all;
}

void LanePart::forget() {
  for (const auto& member : members_) member->forget();
}

long LanePart::fallbacks() const {
  long sum = 0;
  for (const auto& member : members_) sum += member->fallbacks();
  return sum;
}

long LanePart::branch_changes() const {
  long sum = 0;
  for (const auto& member : members_) sum += member->branch_changes();
  return sum;
}

}  // namespace desmo
