#include "formulations/batch/lane_part.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace desmo {

namespace {

/// Lanes left empty cost as much as others: as few as may be.
const CopyKernels& kernels_for(std::size_t copies, const std::vector<CopyKernels>& kernels) {
  const auto hold_all = [&](const CopyKernels& k) {
    return static_cast<std::size_t>(k.front()->lanes) >= copies;
  };
  const auto narrowest = std::ranges::find_if(kernels, hold_all);
  return narrowest == kernels.end() ? kernels.back() : *narrowest;
}

}  // namespace

LanePart::LanePart(std::vector<CopyKernels> kernels, std::vector<Copy> copies,
                   const std::vector<StateKind>& kinds, Guess guess)
    : copies_(std::move(copies)), last_(kinds.size()) {
  for (std::span<Copy> left = copies_; !left.empty();) {
    const CopyKernels& chosen = kernels_for(left.size(), kernels);
    const std::size_t taken =
        std::min(left.size(), static_cast<std::size_t>(chosen.front()->lanes));
    if (taken == 1)
      left_over_ = &left.front();
    else
      batches_.emplace_back(left.first(taken), chosen, kinds, guess);
    left = left.subspan(taken);
  }
}

void LanePart::Result::add(const PartResult& one) {
  all.residual2 += one.residual2;
  all.iterations = std::max(all.iterations, one.iterations);
  if (all.status == Status::converged) all.status = one.status;
}

PartResult LanePart::solve(State& s, std::span<const double> last, Level level) {
  Result result;
  for (LaneBatch& batch : batches_) solve(batch, s, last, level, result);
  if (left_over_) solve_alone(*left_over_, s, last, level, result);
  return result.all;
}

void LanePart::solve(LaneBatch& batch, State& s, std::span<const double> last, Level level,
                     Result& result) {
  const LaneBatch::Step& step = batch.solve(s);
  double residual2 = 0;
  for (std::size_t l = 0; l < batch.copies().size(); ++l)
    if (step.accepted >> l & 1) residual2 += step.residual2[l];
  result.all.residual2 += residual2;
  result.all.iterations = std::max(result.all.iterations, step.iterations);
  if (step.accepted == batch.all()) [[likely]]
    return batch.write_read(s, level);

  std::ranges::copy(last, last_.begin());
  for (std::size_t l = 0; l < batch.copies().size(); ++l) {
    if (batch.predicted()) {
      batch.write_last(l, last_);
      batch.write_last(l, s.q);
    }
    batch.write_driven(l, s);
    if (step.accepted >> l & 1)
      batch.write(l, s);
    else
      solve_alone(batch.copies()[l], s, last_, level, result);
  }
  batch.take(s);
}

/// Up to the first part that cannot be solved: the next may need it.
void LanePart::solve_alone(Copy& copy, State& s, std::span<const double> last, Level level,
                           Result& result) {
  for (const auto& member : copy) {
    const PartResult r = member->solve(s, last, level);
    result.add(r);
    if (r.status != Status::converged) return;
  }
}

std::vector<int> LanePart::starts_from(const std::vector<int>& unknowns) const {
  std::vector<int> all;
  if (left_over_)
    for (const auto& member : *left_over_)
      std::ranges::copy(member->starts_from(unknowns), std::back_inserter(all));
  std::ranges::sort(all);
  return all;
}

std::vector<int> LanePart::stays_near() const {
  std::vector<int> all;
  if (left_over_)
    for (const auto& member : *left_over_)
      std::ranges::copy(member->stays_near(), std::back_inserter(all));
  std::ranges::sort(all);
  return all;
}

void LanePart::write_only(const std::vector<bool>& read) {
  for (LaneBatch& batch : batches_) batch.write_only(read);
}

void LanePart::forget() {
  for (LaneBatch& batch : batches_) batch.forget();
  for (const Copy& copy : copies_)
    for (const auto& member : copy) member->forget();
}

std::vector<int> LanePart::drivers() const {
  std::vector<int> all;
  for (const LaneBatch& batch : batches_)
    std::ranges::copy(batch.drivers(), std::back_inserter(all));
  return all;
}

std::vector<int> LanePart::reads() const {
  std::vector<int> all;
  for (const LaneBatch& batch : batches_) std::ranges::copy(batch.reads(), std::back_inserter(all));
  if (left_over_)
    for (const auto& member : *left_over_)
      std::ranges::copy(member->inputs(), std::back_inserter(all));
  return all;
}

void LanePart::begin_step(const StepHistory& history, const MotionRow& row) {
  std::size_t first = 0;
  for (LaneBatch& batch : batches_) {
    batch.begin_step(history, row.from(first));
    first += batch.in_row();
  }
}

void LanePart::write_last(std::span<double> q) const {
  for (const LaneBatch& batch : batches_)
    for (std::size_t l = 0; batch.predicted() && l < batch.copies().size(); ++l)
      batch.write_last(l, q);
}

void LanePart::write(State& s) const {
  for (const LaneBatch& batch : batches_)
    for (std::size_t l = 0; l < batch.copies().size(); ++l) batch.write(l, s);
}

void LanePart::prepare_outputs(std::span<int> slots, bool drivers_too) {
  for (LaneBatch& batch : batches_) batch.prepare_outputs(slots, drivers_too);
}

void LanePart::fill(const OutputView& output, Level level) const {
  for (const LaneBatch& batch : batches_) batch.fill(output, level);
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
