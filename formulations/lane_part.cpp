#include "formulations/lane_part.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numeric>

namespace desmo {

namespace {

/// Element k of each lane's array.
Lanes pack(const std::array<const double*, lane_count>& arrays, std::size_t k) {
  return Lanes([&](auto lane) { return arrays[lane][k]; });
}

void append(PartResult& all, const PartResult& one, double& residual2) {
  residual2 += one.residual * one.residual;
  all.iterations = std::max(all.iterations, one.iterations);
  if (all.status == Status::converged) all.status = one.status;
}

}  // namespace

LanePart::LanePart(const LaneKernel& kernel, std::vector<std::unique_ptr<ExplicitPart>> members)
    : kernel_(kernel), members_(std::move(members)) {
  const std::size_t inputs = members_.front()->inputs();
  identity_.resize(inputs);
  std::iota(identity_.begin(), identity_.end(), 0);
  for (std::vector<Lanes>* local : {&q_, &qd_, &qdd_}) local->resize(inputs, Lanes(0.0));
  for (std::size_t first = 0; first < members_.size(); first += lane_count)
    batches_.push_back(make_batch(first));
  for (Batch& b : batches_)
    b.binding = {identity_.data(), b.c.data(), b.f.data(),
                 b.branch.data(),  b.w.data(), b.members.front()->binding().limits};
}

LanePart::Batch LanePart::make_batch(std::size_t first) {
  std::vector<ExplicitPart*> members;
  std::array<const int*, lane_count> in;
  std::array<const double*, lane_count> c, f, w;
  for (std::size_t l = 0; l < lane_count; ++l) {
    const bool own = first + l < members_.size();
    ExplicitPart& member = *members_[own ? first + l : first];
    if (own) members.push_back(&member);
    in[l] = member.binding().in;
    c[l] = member.binding().c;
    f[l] = member.binding().f;
    w[l] = member.binding().w;
  }
  Batch batch{.members = std::move(members),
              .positions = {kernel_.positions, in},
              .rates = {kernel_.rates, in},
              .unknowns = {kernel_.unknowns, in}};
  const ExplicitPart& any = *members_.front();
  for (std::size_t k = 0; k < any.constants(); ++k) batch.c.push_back(pack(c, k));
  for (int k = 0; k < any.kernel().folded; ++k) batch.f.push_back(pack(f, k));
  for (std::size_t k = 0; k < any.equations(); ++k) batch.w.push_back(pack(w, k));
  batch.branch.resize(any.kernel().branches.size());
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
    pack_branches(batch);
    return;
  }
  batch.positions.gather(s.q.data(), q_.data());
  batch.rates.gather(s.qd.data(), qd_.data());
  batch.rates.gather(s.qdd.data(), qdd_.data());

  const ExplicitResult<Lanes> r = kernel_.solve(q_.data(), qd_.data(), qdd_.data(), batch.binding);

  const int lanes = static_cast<int>(batch.members.size());
  unsigned accepted = 0;
  for (int l = 0; l < lane_count; ++l)  // what fills the rest is written like the first
    accepted |= static_cast<unsigned>(r.accepted[l < lanes ? l : 0]) << l;
  batch.unknowns.scatter(q_.data(), accepted, s.q.data());
  if (level >= Level::velocity) batch.unknowns.scatter(qd_.data(), accepted, s.qd.data());
  if (level >= Level::acceleration) batch.unknowns.scatter(qdd_.data(), accepted, s.qdd.data());
  result.iterations = std::max(result.iterations, r.iterations);
  for (int l = 0; l < lanes; ++l)
    if (r.accepted[l])
      residual2 += r.residual2[l];
    else
      append(result, batch.members[l]->solve(s, level), residual2);
  if (!all(r.accepted)) pack_branches(batch);
}

void LanePart::pack_branches(Batch& batch) {
  for (std::size_t k = 0; k < batch.branch.size(); ++k)
    batch.branch[k] = Lanes([&](auto lane) {
      const std::size_t l = lane < batch.members.size() ? static_cast<std::size_t>(lane) : 0;
      return batch.members[l]->branches()[k];
    });
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
