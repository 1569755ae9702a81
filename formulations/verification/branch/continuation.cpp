#include "formulations/verification/branch/continuation.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "formulations/verification/branch/branch_path.h"
#include "formulations/verification/branch/chosen_equations.h"
#include "formulations/verification/branch/passage.h"

namespace desmo {

/// The loop ends: each round but the last chooses other equations at a new place, or passes a
/// change point. Each round in which a path has begun counts as at least one test of the budget.
/// All passages share another budget.
bool follow_continuation(const Model& m, bool may_pass, FoundStart& found) {
  std::unique_ptr<const Model> chosen;  // the model with other equations; null: m itself
  auto path = std::make_unique<BranchPath>(m);
  const auto model = [&]() -> const Model& { return chosen ? *chosen : m; };
  const auto choose = [&] {
    auto other = with_chosen_equations(model(), found.q);
    if (!other) return false;
    auto on = std::make_unique<BranchPath>(*other);
    if (!on->start_at({found.share, {found.q, {}, {}}})) return false;
    path = std::move(on);
    chosen = std::move(other);
    return true;
  };
  const auto take_positions = [&] {
    const std::span<const double> q = path->present().values.position;
    found.q.assign(q.begin(), q.end());
  };
  FollowedStep step;
  int tests = 0;
  double chosen_at = -1;  // share at which other equations were asked for last
  TestBudget passages(BranchPath::max_tests);
  found.share = 0;
  bool begun = path->start_at({0, {found.q, {}, {}}});
  while (true) {
    if (begun) {
      step = path->go_to(1);
      tests += std::max(1, step.tests);
      take_positions();
      found.share = path->present().time;
      if (step.end == PathEnd::same) break;
    }
    if (tests >= BranchPath::max_tests) break;
    const bool is_asked = std::exchange(chosen_at, found.share) == found.share;
    if (!is_asked && choose()) {
      begun = true;
      continue;
    }
    if (!begun || !may_pass) break;
    const std::optional<PassedPoint> point =
        pass_change_point(model(), path->present(), step.group, passages);
    if (!point || !(point->before < 1)) break;
    begun = path->start_at(point->beyond());
    if (!begun) break;
    found.passed.push_back(point->time);
  }
  found.out_of_tests = step.end == PathEnd::stuck && tests >= BranchPath::max_tests;
  if (begun) found.group = step.group;
  // Corrects the last digits at the end of the way.
  if (step.end == PathEnd::same && path->start_at({1, {found.q, {}, {}}})) take_positions();
  return step.end == PathEnd::same;
}

}  // namespace desmo
