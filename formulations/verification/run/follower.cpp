#include "formulations/verification/run/follower.h"

#include <utility>

namespace desmo {

Follower::Follower(std::unique_ptr<const Model> c, const Model& m, std::span<const Level> levels,
                   int budget)
    : chosen(std::move(c)),
      model(chosen ? *chosen : m),
      refinement(model, levels),
      path(model, budget),
      left_out(model) {
  if (left_out.any())
    path.ask_about_steps([this](const PathProof& step) { return left_out.look_along(step); });
}

RowFlag start_flag(RowFlag::Kind kind, const FoundStart& start, double time) {
  return {.kind = kind,
          .time = time,
          .after = time,
          .before = time,
          .group = start.group,
          .out_of_tests = start.out_of_tests};
}

void Follower::flag_misfit(const RefinedInstant& r, std::optional<RowFlag>& flag,
                           const LiveRow* live) {
  const double offset = live ? live->time : 0;
  std::optional<Misfit> misfit = left_out.check(r, live);
  double time = offset + r.instant.time;
  if (const auto between = left_out.take_between();
      between && (!misfit || between->misfit.relative > misfit->relative)) {
    misfit = between->misfit;
    time = offset + between->time;
  }
  if (!misfit) return;
  if (!flag)
    flag = {.kind = RowFlag::Kind::misfit,
            .after = time,
            .before = time,
            .group = model.constraints[misfit->constraint].group};
  flag->misfit = misfit;
}

}  // namespace desmo
