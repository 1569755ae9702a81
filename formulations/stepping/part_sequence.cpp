#include "formulations/stepping/part_sequence.h"

#include <algorithm>
#include <cstddef>
#include <utility>

namespace desmo {

PartSequence::PartSequence(std::vector<DefinedPart> parts) : parts_(std::move(parts)) {
  make_stages();
}

void PartSequence::solve_only(std::span<const Level> needed) {
  for (DefinedPart& part : parts_) {
    part.level = Level::position;
    for (const int i : part.definition.unknowns) part.level = std::max(part.level, needed[i]);
  }
  make_stages();
}

void PartSequence::make_stages() {
  constant_.clear();
  moving_.clear();
  for (std::size_t i = 0; i < parts_.size(); ++i) {
    const DefinedPart& part = parts_[i];
    (part.definition.constant ? constant_ : moving_)
        .push_back({part.solver.get(), part.level, static_cast<int>(i),
                    static_cast<int>(part.definition.unknowns.size())});
  }
  make_runs();
}

/// Makes runs of moving parts that follow each other and are solved to the same level.
void PartSequence::make_runs() {
  runs_.clear();
  std::vector<Part*> solvers;
  for (const Stage& stage : moving_) solvers.push_back(stage.solver);
  std::size_t same_level = 0;  // the end of the parts that are solved to one level
  for (std::size_t first = 0; first < moving_.size();) {
    while (same_level < moving_.size() &&
           (same_level <= first || moving_[same_level].level == moving_[first].level))
      ++same_level;
    std::unique_ptr<PartRun> run =
        solvers[first]->make_run(std::span(solvers).subspan(first, same_level - first));
    const int members = run ? run->size() : 1;
    for (int i = 0; run && i < members; ++i) {
      moving_[first + i].run = run.get();
      moving_[first + i].member = i;
    }
    if (run) runs_.push_back(std::move(run));
    first += members;
  }
}

PartSequence::Result PartSequence::solve(std::span<const Stage> stages, State& state,
                                         std::span<const double> last, Level level) {
  Result result;
  for (std::size_t i = 0; i < stages.size();) {
    if (PartRun* const run = stages[i].run) {
      const Stage& first = stages[i];
      const PartRun::Result r = run->solve(state, first.member, std::min(level, first.level));
      result.residual2 += r.residual2;
      result.iterations = std::max<long>(result.iterations, r.iterations);
      result.updates += r.all * first.unknowns;
      i += r.solved;
      if (first.member + r.solved == run->size()) continue;
    }
    const Stage& stage = stages[i++];
    const PartResult r = stage.solver->solve(state, last, std::min(level, stage.level));
    result.residual2 += r.residual2;
    result.iterations = std::max<long>(result.iterations, r.iterations);
    result.updates += static_cast<long>(r.iterations) * stage.unknowns;
    if (r.status != Status::converged) {
      result.status = r.status;
      result.failed = stage.part;
      break;
    }
  }
  return result;
}

bool PartSequence::solve_positions(State& state, std::span<const double> last) const {
  return std::ranges::all_of(moving_, [&](const Stage& stage) {
    return stage.solver->solve(state, last, Level::position).status == Status::converged;
  });
}

void PartSequence::forget() {
  for (const DefinedPart& part : parts_) part.solver->forget();
  for (const auto& run : runs_) run->forget();
}

void PartSequence::end_assembly() {
  for (const DefinedPart& part : parts_) part.solver->end_assembly();
}

}  // namespace desmo
