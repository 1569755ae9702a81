#include "formulations/batch/batch_part.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace desmo {

namespace {

/// Returns the kernels with the fewest lanes that hold all subsystems: empty lanes cost as much as
/// others. Returns those with the most lanes where none hold all.
const SubsystemKernels& kernels_for(std::size_t subsystems,
                                    const std::vector<SubsystemKernels>& kernels) {
  const auto hold_all = [&](const SubsystemKernels& k) {
    return static_cast<std::size_t>(k.front()->lanes) >= subsystems;
  };
  const auto narrowest = std::ranges::find_if(kernels, hold_all);
  return narrowest == kernels.end() ? kernels.back() : *narrowest;
}

}  // namespace

BatchPart::BatchPart(std::vector<SubsystemKernels> kernels, std::vector<Subsystem> subsystems,
                     const std::vector<StateKind>& kinds, Guess guess)
    : subsystems_(std::move(subsystems)), last_(kinds.size()) {
  for (std::span<Subsystem> left = subsystems_; !left.empty();) {
    const SubsystemKernels& chosen = kernels_for(left.size(), kernels);
    const std::size_t taken =
        std::min(left.size(), static_cast<std::size_t>(chosen.front()->lanes));
    if (taken == 1)
      left_over_ = &left.front();
    else
      batches_.emplace_back(left.first(taken), chosen, kinds, guess);
    left = left.subspan(taken);
  }
}

PartResult BatchPart::solve(State& s, std::span<const double> last, Level level) {
  PartResult all;
  for (Batch& batch : batches_) solve(batch, s, last, level, all);
  if (left_over_) solve_alone(*left_over_, s, last, level, all);
  return all;
}

void BatchPart::solve(Batch& batch, State& s, std::span<const double> last, Level level,
                      PartResult& all) {
  const Batch::Step& step = batch.solve(s);
  double residual2 = 0;
  for (std::size_t l = 0; l < batch.subsystems().size(); ++l)
    if (step.accepted >> l & 1) residual2 += step.residual2[l];
  all.residual2 += residual2;
  all.iterations = std::max(all.iterations, step.iterations);
  if (step.accepted == batch.all()) [[likely]]
    return batch.write_observed(s, level);

  std::ranges::copy(last, last_.begin());
  for (std::size_t l = 0; l < batch.subsystems().size(); ++l) {
    if (batch.predicted()) {
      batch.restore(l, last_);
      batch.restore(l, s.q);
    }
    batch.store_drivers(l, s);
    if (step.accepted >> l & 1)
      batch.store(l, s);
    else
      solve_alone(batch.subsystems()[l], s, last_, level, all);
  }
  batch.copy_from(s);
}

/// Solves the parts of a subsystem up to the first that cannot be solved: the next may need it.
void BatchPart::solve_alone(Subsystem& subsystem, State& s, std::span<const double> last,
                            Level level, PartResult& all) {
  for (const auto& part : subsystem) {
    const PartResult r = part->solve(s, last, level);
    all.residual2 += r.residual2;
    all.iterations = std::max(all.iterations, r.iterations);
    if (r.status == Status::solved) continue;
    if (all.status == Status::solved) all.status = r.status;
    return;
  }
}

PartInputs BatchPart::inputs(PartInputs) const {
  PartInputs all;
  const auto append = [](const auto& from, std::vector<int>& to) {
    std::ranges::copy(from, std::back_inserter(to));
  };
  for (const Batch& batch : batches_) {
    append(batch.drivers(), all.drivers);
    append(batch.inputs(), all.others);
  }
  if (left_over_)
    for (const auto& part : *left_over_) {
      const PartInputs inputs = part->inputs({});
      append(inputs.predicted, all.predicted);
      append(inputs.unwrapped, all.unwrapped);
      append(part->places(), all.others);
    }
  std::ranges::sort(all.predicted);
  std::ranges::sort(all.unwrapped);
  return all;
}

void BatchPart::bind(const PartOutputs& outputs) {
  for (Batch& batch : batches_) batch.bind(outputs);
}

void BatchPart::begin_step(const StepHistory& history, const MotionRow& row) {
  std::size_t first = 0;
  for (Batch& batch : batches_) {
    batch.begin_step(history, row.from(first));
    first += batch.in_row();
  }
}

void BatchPart::deliver(const OutputView& output, Level level) const {
  for (const Batch& batch : batches_) batch.deliver(output, level);
}

void BatchPart::store(State& s) const {
  for (const Batch& batch : batches_)
    for (std::size_t l = 0; l < batch.subsystems().size(); ++l) batch.store(l, s);
}

void BatchPart::restore(std::span<double> q) const {
  for (const Batch& batch : batches_)
    for (std::size_t l = 0; batch.predicted() && l < batch.subsystems().size(); ++l)
      batch.restore(l, q);
}

void BatchPart::forget() {
  for (Batch& batch : batches_) batch.forget();
  for (const Subsystem& subsystem : subsystems_)
    for (const auto& part : subsystem) part->forget();
}

PartCounts BatchPart::counts() const {
  PartCounts sum;
  for (const Subsystem& subsystem : subsystems_)
    for (const auto& part : subsystem) sum += part->counts();
  return sum;
}

}  // namespace desmo
