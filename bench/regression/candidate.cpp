#include "bench/regression/candidate.h"

#include <cmath>

#include "cases/generators/cases.h"
#include "formulations/modelling/modelling.h"

namespace desmo::regression {

Subject::Subject(const CellName& cell, int instants, const Settings& settings)
    : configuration_(parse_id(cell.id, settings)),
      model_(make_model(describe(find_case(cell.case_name), cell.coordinates))),
      formulation_(make_formulation(*configuration_.variant, model_, configuration_.settings)),
      delivery_(model_.coordinates()),
      grid_{0, 0.01, instants} {}

Summary Subject::analyse() { return formulation_->run(grid_, {}, delivery_); }

Summary Subject::walk(int first, int last) {
  const int direction = first <= last ? 1 : -1;
  for (int i = first;; i += direction) {
    const Summary s = formulation_->step(grid_.time(i));
    if (!s.ok()) return s;
    delivery_.observe(
        {i, grid_.time(i), formulation_->q(), formulation_->qd(), formulation_->qdd()});
    if (i == last) return s;
  }
}

int extra_steps(int steps, double percent) {
  return static_cast<int>(std::lround(steps * percent / 100));
}

}  // namespace desmo::regression
