#include "formulations/motion/part_sequence.h"

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <utility>

namespace desmo {

PartSequence::PartSequence(const Model& model, std::vector<DefinedPart> parts)
    : parts_(std::move(parts)) {
  for (const DefinedPart& part : parts_)
    inputs_.push_back(part.solver->inputs(equation_inputs(model, part.definition)));
  order_parts();
}

void PartSequence::solve_only(std::span<const Level> needed) {
  for (DefinedPart& part : parts_) {
    part.level = Level::position;
    for (const int i : part.definition.unknowns) part.level = std::max(part.level, needed[i]);
  }
  order_parts();
}

void PartSequence::order_parts() {
  constant_.clear();
  moving_.clear();
  residents_.clear();
  drivers_.clear();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const DefinedPart& part = parts_[i];
    (part.definition.constant ? constant_ : moving_)
        .push_back({part.solver.get(), part.level, static_cast<int>(i),
                    static_cast<int>(part.definition.unknowns.size())});
    ResidentPart* const resident = part.solver->resident();
    if (part.definition.constant || !resident) continue;
    residents_.push_back({resident, part.level, drivers_.size()});
    std::ranges::copy(inputs_[i].drivers, std::back_inserter(drivers_));
  }
  make_chains();
}

/// Makes chains of moving parts that follow each other and are solved to the same level.
void PartSequence::make_chains() {
  chains_.clear();
  std::vector<Part*> solvers;
  for (const PartInStep& part : moving_) solvers.push_back(part.solver);
  std::size_t same_level = 0;  // end of the parts that are solved to the level of the first
  for (std::size_t first = 0; first < moving_.size();) {
    while (same_level < moving_.size() &&
           (same_level <= first || moving_[same_level].level == moving_[first].level))
      ++same_level;
    std::unique_ptr<PartChain> chain =
        solvers[first]->make_chain(std::span(solvers).subspan(first, same_level - first));
    const int parts = chain ? chain->size() : 1;
    for (int i = 0; chain && i < parts; ++i) {
      moving_[first + i].chain = chain.get();
      moving_[first + i].chain_position = i;
    }
    if (chain) chains_.push_back(std::move(chain));
    first += parts;
  }
}

// ---- The loop over structural groups of the paper's Fig. 2a ----

/// Solves one part after the other, each as in Fig. 2b (NewtonSolver).
PartSequence::Result PartSequence::solve_in_order(std::span<const PartInStep> parts, State& state,
                                                  std::span<const double> last, Level level) {
  Result result;
  while (!(parts = solve_chains(parts, state, level, result)).empty()) {
    const PartInStep& part = parts.front();
    const PartResult r = part.solver->solve(state, last, std::min(level, part.level));
    result.add(r.residual2, r.iterations, static_cast<long>(r.iterations) * part.unknowns);
    if (r.status != Status::solved) {
      result.status = r.status;
      result.failed = part.position;
      break;
    }
    parts = parts.subspan(1);
  }
  return result;
}

/// Solves the chains with which `parts` begins, each in one call. Returns what is left of `parts`:
/// it begins with one that has to be solved by itself, or is empty.
[[gnu::always_inline]] inline std::span<const PartSequence::PartInStep> PartSequence::solve_chains(
    std::span<const PartInStep> parts, State& state, Level level, Result& result) {
  while (!parts.empty() && parts.front().chain) {
    const PartInStep& first = parts.front();
    const PartChain::Result r =
        first.chain->solve(state, first.chain_position, std::min(level, first.level));
    result.add(r.residual2, r.iterations, r.total_iterations * first.unknowns);
    parts = parts.subspan(static_cast<std::size_t>(r.solved));
    if (first.chain_position + r.solved < first.chain->size()) break;
  }
  return parts;
}

bool PartSequence::solve_positions(State& state, std::span<const double> last) const {
  return std::ranges::all_of(moving_, [&](const PartInStep& part) {
    return part.solver->solve(state, last, Level::position).status == Status::solved;
  });
}

void PartSequence::bind(std::vector<bool>& observed, std::span<int> places) {
  for (const PartInputs& inputs : inputs_)
    for (const std::vector<int>* read : {&inputs.predicted, &inputs.unwrapped, &inputs.others})
      for (const int i : *read) observed[i] = true;
  for (const Resident& r : residents_) r.part->bind({observed, places, r.level});
}

void PartSequence::begin_step(const StepHistory& history, const MotionRow& row) {
  for (const auto& [part, level, first_driver] : residents_)
    part->begin_step(history.up_to(level), row.from(first_driver));
}

void PartSequence::deliver(const OutputView& output, Level level) const {
  for (const Resident& r : residents_) r.part->deliver(output, std::min(level, r.level));
}

void PartSequence::store(State& state) const {
  for (const Resident& r : residents_) r.part->store(state);
}

void PartSequence::restore(std::span<double> q) const {
  for (const Resident& r : residents_) r.part->restore(q);
}

void PartSequence::forget() {
  for (const DefinedPart& part : parts_) part.solver->forget();
  for (const auto& chain : chains_) chain->forget();
}

void PartSequence::end_assembly() {
  for (const DefinedPart& part : parts_) part.solver->end_assembly();
}

}  // namespace desmo
