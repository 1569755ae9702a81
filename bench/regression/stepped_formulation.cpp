#include "bench/regression/stepped_formulation.h"

#include <cmath>

#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"

namespace desmo::regression {

bench::Problem problem_of(const bench::CandidateName& name, int instants) {
  bench::Problem problem;
  problem.plan.model = make_model(make_scene(find_case(name.case_name), name.coordinates),
                                  parse_id(name.id).settings.coordinates);
  problem.grid = {0, 0.01, instants};
  return problem;
}

SteppedFormulation::SteppedFormulation(const bench::Problem& problem, std::string_view id,
                                       const Settings& others)
    : grid(problem.grid),
      configuration_(parse_id(id, others)),
      formulation_(
          make_formulation(*configuration_.variant, problem.plan.model, configuration_.settings)),
      output_({}, problem.plan.model.coordinates()),
      delivery_(problem.plan.model.coordinates()) {}

Summary SteppedFormulation::walk(int first, int last) {
  const int direction = first <= last ? 1 : -1;
  for (int i = first;; i += direction) {
    const Summary s = formulation_->step(grid.time(i));
    if (!s.ok()) return s;
    output_.hand_over({i, grid.time(i), formulation_->q(), formulation_->qd(), formulation_->qdd()},
                      delivery_);
    if (i == last) return s;
  }
}

int extra_steps(int steps, double percent) {
  return static_cast<int>(std::lround(steps * percent / 100));
}

}  // namespace desmo::regression
