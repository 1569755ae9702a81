#pragma once

#include <cstddef>
#include <utility>
#include <vector>

#include "formulations/parts/explicit_part.h"

namespace desmo {

/// Parts in explicit order that share a kernel, solved in one call of it. One that the kernel
/// refuses is tried by it once more when it is solved by itself.
class ExplicitRun final : public PartRun {
 public:
  /// members: of one kernel; they outlive the run, and what their bindings point to stays where it
  /// is.
  explicit ExplicitRun(std::vector<const ExplicitPart*> members) : members_(std::move(members)) {
    for (const ExplicitPart* const member : members_) bindings_.push_back(member->binding());
  }

  int size() const override { return static_cast<int>(members_.size()); }

  Result solve(State& s, int first, Level level) override {
    while (assembled_ < size() && members_[assembled_]->assembled()) ++assembled_;
    if (assembled_ < size()) return {};
    ExplicitKernel::Solve* const solve =
        members_.front()->kernel().solve[static_cast<std::size_t>(level)];
    const auto [accepted, iterations, all, residual2] =
        solve(s.q.data(), s.qd.data(), s.qdd.data(), bindings_.data() + first, size() - first);
    return {accepted, iterations, all, residual2};
  }

  void forget() override { assembled_ = 0; }

 private:
  std::vector<const ExplicitPart*> members_;
  std::vector<ExplicitBinding<double>> bindings_;  // of the members, beside each other in memory
  int assembled_ = 0;                              // members from the first on, since forget()
};

}  // namespace desmo
